use answer::Witness;
use cagd::affine::{Affine, Point};
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};

type Exact = Point<BigRational, 2>;

fn whole(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

/// (x − centre)² + y².
fn square_distance(point: &Exact, centre: i64) -> BigRational {
    let x = &point[0] - whole(centre);
    &x * &x + &point[1] * &point[1]
}

fn in_ring(point: &Exact) -> bool {
    let distance = square_distance(point, 0);
    whole(4) <= distance && distance <= whole(25)
}

fn in_crescent(point: &Exact) -> bool {
    square_distance(point, 0) <= whole(25) && square_distance(point, 4) >= whole(25)
}

fn in_two_discs(point: &Exact) -> bool {
    [4, -4]
        .iter()
        .any(|&centre| square_distance(point, centre) <= whole(9))
}

fn on_circle_line(point: &Exact) -> bool {
    square_distance(point, 0) == whole(25)
}

fn probes() -> Vec<String> {
    let words = |w: Witness| format!("{:?} {:?} {}", w.p, w.q, w.t);
    cagd::probes![
        words(answer::ring()),
        words(answer::crescent()),
        words(answer::two_discs()),
        words(answer::circle_line()),
    ]
}

/// The circle around (centre, 0), to be drawn.
fn circle(centre: f64, radius: f64) -> Vec<Point<f64, 2>> {
    let angle = |k: i32| f64::from(k) * std::f64::consts::TAU / 64.0;
    (0..=64)
        .map(|k| Point::new([centre + radius * angle(k).cos(), radius * angle(k).sin()]))
        .collect()
}

/// The claim that the witness shows that the set is not convex.
fn check(name: &str, contains: fn(&Exact) -> bool, circles: [(f64, f64); 2], witness: &Witness) {
    let [p, q] = [witness.p, witness.q].map(|xy| Exact::new(xy.map(whole)));
    let between = p.lerp(&q, witness.t.clone());
    let input = format!("P = {p}, Q = {q}, t = {}", witness.t);
    let picture = || {
        let boundary = circles.map(|(centre, radius)| circle(centre, radius));
        let picture = boundary.into_iter().fold(Picture::new(), Picture::given);
        picture
            .found([p.clone(), q.clone()])
            .found([between.clone()])
    };
    for (point, letter) in [(&p, "P"), (&q, "Q")] {
        claim(format!("whether {letter} belongs to the {name}"))
            .input(&input)
            .picture(picture)
            .holds(
                contains(point),
                "a point of the set",
                format!("{point}, which is none"),
            );
    }
    claim("whether t leads to a point of the segment")
        .input(&input)
        .picture(picture)
        .holds(
            whole(0) <= witness.t && witness.t <= whole(1),
            "0 ≤ t ≤ 1",
            format!("t = {}", witness.t),
        );
    claim(format!("whether (1 − t)P + tQ leaves the {name}"))
        .input(&input)
        .picture(picture)
        .holds(
            !contains(&between),
            "a point that is not in the set",
            format!("{between}, which is in it"),
        );
}

/// The hole of the ring lies between its points.
#[test]
fn the_ring() {
    check("ring", in_ring, [(0.0, 2.0), (0.0, 5.0)], &answer::ring());
}

/// So does the bite of the crescent.
#[test]
fn the_crescent() {
    check(
        "crescent",
        in_crescent,
        [(0.0, 5.0), (4.0, 5.0)],
        &answer::crescent(),
    );
}

/// And the gap between the discs.
#[test]
fn the_two_discs() {
    check(
        "two discs",
        in_two_discs,
        [(-4.0, 3.0), (4.0, 3.0)],
        &answer::two_discs(),
    );
}

/// A line that is curved contains no segment at all.
#[test]
fn the_circle_line() {
    check(
        "circle line",
        on_circle_line,
        [(0.0, 5.0), (0.0, 5.0)],
        &answer::circle_line(),
    );
}
