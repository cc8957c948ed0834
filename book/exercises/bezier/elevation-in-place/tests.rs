use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn number(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

fn points(coordinates: &[[i64; 2]]) -> Vec<Point<BigRational, 2>> {
    let point = |xy: &[i64; 2]| Point::new(xy.map(number));
    coordinates.iter().map(point).collect()
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::elevated_to(&points(&[[0, 0], [3, 6], [9, 0]]), 3),
        answer::elevated_to(&points(&[[0, 0], [6, 12]]), 3),
        answer::elevated_to(&points(&[[1, 2]]), 0),
    ]
}

/// The claim that the answer gives these points.
fn compare(b: &[[i64; 2]], m: usize, right: Vec<Point<BigRational, 2>>) {
    let found = || answer::elevated_to(&points(b), m);
    claim(format!("the control points of degree {m}"))
        .input(format!("control points {b:?}, m = {m}"))
        .picture(|| {
            Picture::new()
                .given(points(b))
                .expected(right.clone())
                .found(found())
        })
        .equal(found(), right.clone());
}

/// Why: the degree is already the wanted one, so no step is needed.
#[test]
fn nothing_to_do() {
    compare(&[[1, 2]], 0, points(&[[1, 2]]));
    compare(
        &[[0, 0], [3, 6], [9, 0]],
        2,
        points(&[[0, 0], [3, 6], [9, 0]]),
    );
}

/// Why: what was right must stay right.
#[test]
fn what_was_right_before() {
    compare(&[[5, 1]], 3, points(&[[5, 1]; 4]));
    compare(&[[0, 0], [4, 2]], 2, points(&[[0, 0], [2, 1], [4, 2]]));
}

/// Why: one step, so the denominator cannot go wrong; only the order of the assignments can.
#[test]
fn one_step_of_a_parabola() {
    compare(
        &[[0, 0], [3, 6], [9, 0]],
        3,
        points(&[[0, 0], [2, 4], [5, 4], [9, 0]]),
    );
}

/// Why: equal distances on a line show a wrong denominator at once.
#[test]
fn two_steps_of_a_segment() {
    compare(
        &[[0, 0], [6, 12]],
        3,
        points(&[[0, 0], [2, 4], [4, 8], [6, 12]]),
    );
}

proptest! {
    /// Why: any degree, any number of steps.
    #[test]
    fn every_curve(b in prop::collection::vec(any::<[i8; 2]>(), 1..=5), steps in 0..=4_usize) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let curve = BezierCurve::new(points(&b)).expect("at least one point");
        let right = curve.elevated_times(steps).control_points().to_vec();
        compare(&b, curve.degree() + steps, right);
    }
}
