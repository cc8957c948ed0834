use cagd::affine::{CentralProjection, Line, Point};
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn point(xy: [i64; 2]) -> Point<BigRational, 2> {
    Point::new(xy.map(|n| fraction(n, 1)))
}

fn midpoint(p: &Point<BigRational, 2>, q: &Point<BigRational, 2>) -> Point<BigRational, 2> {
    p.clone() + (q.clone() - p.clone()) * fraction(1, 2)
}

fn probes() -> Vec<String> {
    cagd::probes![answer::points()]
}

/// Where the library's camera at the origin sees a point of the upper half-plane on the line y = 1.
fn image(of: &Point<BigRational, 2>) -> Point<BigRational, 2> {
    let screen = Line::new([fraction(0, 1), fraction(1, 1)], fraction(1, 1)).expect("a line");
    let camera = CentralProjection::new(Point::origin(), screen).expect("it is not on the line");
    camera.point(of).expect("the point is above the camera")
}

fn input([a, b]: [[i64; 2]; 2]) -> String {
    format!("A = {}, B = {}", point(a), point(b))
}

/// The camera must see both points.
#[test]
fn both_points_lie_above_the_camera() {
    let pair = answer::points();
    let [low, high] = pair.map(|[_, y]| y);
    claim("the heights of A and B").input(input(pair)).holds(
        low > 0 && high > 0,
        "y > 0 for both",
        format!("y = {low} and y = {high}"),
    );
}

/// The image of the midpoint is another point than the midpoint of the images.
#[test]
fn the_midpoint_is_lost() {
    let pair = answer::points();
    if pair.iter().any(|&[_, y]| y <= 0) {
        return; // The other test tells it.
    }
    let [a, b] = pair.map(point);
    let seen = image(&midpoint(&a, &b));
    let middle = midpoint(&image(&a), &image(&b));
    claim("the image of the midpoint of A and B")
        .input(input(pair))
        .picture(|| {
            Picture::new()
                .given([a.clone(), b.clone()])
                .given([image(&a), image(&b)])
                .given([Point::origin(), midpoint(&a, &b)])
                .found([seen.clone()])
        })
        .holds(
            seen != middle,
            format!(
                "another place than {}, the midpoint of the images",
                middle[0]
            ),
            format!("x/y = {}", seen[0]),
        );
}
