use cagd::affine::{Interval, Point};
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn point([x, y]: [i64; 2]) -> Point<BigRational, 2> {
    Point::new([fraction(x, 1), fraction(y, 1)])
}

fn points(coordinates: &[[i64; 2]]) -> Vec<Point<BigRational, 2>> {
    coordinates.iter().copied().map(point).collect()
}

fn probes() -> Vec<String> {
    let b = points(&[[0, 0], [0, 4], [2, 6]]);
    cagd::probes![
        answer::joint(&b, [fraction(1, 1), fraction(2, 1)], 3),
        answer::joint(&b, [fraction(3, 1), fraction(1, 1)], 2),
        answer::joint(
            &points(&[[0, 0], [5, 1], [5, 1]]),
            [fraction(1, 1), fraction(1, 1)],
            2
        ),
    ]
}

/// The claim that the second piece starts with these points.
fn compare(b: &[[i64; 2]], lengths: [i64; 2], m: usize, right: [Point<BigRational, 2>; 2]) {
    let lengths = lengths.map(|h| fraction(h, 1));
    let found = || answer::joint(&points(b), lengths.clone(), m);
    claim("the first two control points of the second piece")
        .input(format!(
            "control points {b:?}, lengths {} and {}, m = {m}",
            lengths[0], lengths[1]
        ))
        .picture(|| {
            Picture::new()
                .given(points(b))
                .expected(right.clone())
                .found(found())
        })
        .equal(found(), right.clone());
}

/// Why: equal lengths and degrees; the last leg is simply drawn again.
#[test]
fn twins() {
    compare(
        &[[0, 0], [0, 4], [2, 6]],
        [1, 1],
        2,
        [[2, 6], [4, 8]].map(point),
    );
}

/// Why: only the lengths differ.
#[test]
fn twice_the_time() {
    compare(
        &[[0, 0], [0, 4], [2, 6]],
        [1, 2],
        2,
        [[2, 6], [6, 10]].map(point),
    );
}

/// Why: only the degrees differ.
#[test]
fn another_degree() {
    compare(&[[0, 0], [3, 6]], [1, 1], 3, [[3, 6], [4, 8]].map(point));
}

/// Why: a last leg without length means that the first piece ends at rest, and the second begins so.
#[test]
fn at_rest() {
    compare(
        &[[0, 0], [5, 1], [5, 1]],
        [1, 3],
        2,
        [[5, 1], [5, 1]].map(point),
    );
}

proptest! {
    /// Why: it compares the motion itself, position and velocity, for all lengths and degrees.
    #[test]
    fn one_motion(
        b in prop::collection::vec(any::<[i8; 2]>(), 2..=5),
        rest in prop::collection::vec(any::<[i8; 2]>(), 0..=3),
        h in 1..=6_i64,
        k in 1..=6_i64,
    ) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let joint = fraction(h, 2);
        let end = joint.clone() + fraction(k, 3);
        let first = Interval::new(fraction(0, 1), joint.clone()).expect("h is positive");
        let second = Interval::new(joint.clone(), end).expect("k is positive");

        let first = BezierCurve::on(first, points(&b)).expect("at least two points");
        let found = answer::joint(&points(&b), [fraction(h, 2), fraction(k, 3)], rest.len() + 1);
        let others = rest.iter().map(|xy| point(xy.map(i64::from)));
        let polygon: Vec<_> = found.into_iter().chain(others).collect();
        let second = BezierCurve::on(second, polygon.clone()).expect("at least two points");
        claim("position and velocity of the second piece at the joint")
            .picture(|| Picture::new().given(points(&b)).found(polygon))
            .equal(
                (second.at(joint.clone()), second.derivative().at(joint.clone())),
                (first.at(joint.clone()), first.derivative().at(joint)),
            );
    }
}
