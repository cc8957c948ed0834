use cagd::affine::{Affine, Point};
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, OrderedScalar, Scalar};

type Exact = Point<BigRational, 2>;

fn whole(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

fn points(way: [[i64; 2]; 3]) -> [Exact; 3] {
    way.map(|xy| Point::new(xy.map(whole)))
}

fn stretched(point: &Exact, k: i64) -> Exact {
    Point::new([&point[0] * whole(k), point[1].clone()])
}

fn probes() -> Vec<String> {
    cagd::probes![format!("{:?}", answer::way())]
}

/// The length of a segment that is parallel to an axis.
fn length(p: &Exact, q: &Exact) -> BigRational {
    OrderedScalar::abs(&(&q[0] - &p[0])) + OrderedScalar::abs(&(&q[1] - &p[1]))
}

/// Where half of the way is done.
fn resting_place([p, q, r]: &[Exact; 3]) -> Exact {
    let (first, second) = (length(p, q), length(q, r));
    let half = (&first + &second) / whole(2);
    if half <= first {
        p.lerp(q, half / first)
    } else {
        q.lerp(r, (half - first) / second)
    }
}

fn input() -> String {
    let ([p, q, r], k) = answer::way();
    format!("P = {p:?}, Q = {q:?}, R = {r:?}, k = {k}")
}

/// Whether the answer keeps to the rules, and what is wrong with it otherwise.
fn broken_rule() -> Option<String> {
    let (way, k) = answer::way();
    let segments = [(way[0], way[1]), (way[1], way[2])];
    if let Some((p, _)) = segments.iter().find(|(p, q)| p == q) {
        return Some(format!("the segment from {p:?} to itself"));
    }
    let slanted = segments.iter().find(|(p, q)| p[0] != q[0] && p[1] != q[1]);
    if let Some((p, q)) = slanted {
        return Some(format!("the slanted segment from {p:?} to {q:?}"));
    }
    (k < 2).then(|| format!("k = {k}"))
}

/// The segments are parallel to the axes, and the map is a stretching.
#[test]
fn the_rules_are_kept() {
    let found = broken_rule();
    claim("the way and the factor").input(input()).holds(
        found.is_none(),
        "two segments that are parallel to an axis, and k ≥ 2",
        found.unwrap_or_default(),
    );
}

/// The image of the resting place is not where one rests on the image of the way.
#[test]
fn the_resting_place_is_lost() {
    if broken_rule().is_some() {
        return; // The other test tells it.
    }
    let (way, k) = answer::way();
    let way = points(way);
    let image = way.each_ref().map(|point| stretched(point, k));
    let place = resting_place(&way);
    let (moved, right) = (stretched(&place, k), resting_place(&image));
    claim("the image of the resting place")
        .input(input())
        .picture(|| {
            Picture::new()
                .given(way.clone())
                .given([place.clone()])
                .given(image.clone())
                .found([moved.clone()])
        })
        .holds(
            moved != right,
            format!("another point than {right}, the resting place of the image"),
            format!("{moved}"),
        );
}
