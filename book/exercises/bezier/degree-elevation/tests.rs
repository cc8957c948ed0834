use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn points(coordinates: &[[i64; 2]]) -> Vec<Point<BigRational, 2>> {
    let point = |xy: &[i64; 2]| Point::new(xy.map(|n| fraction(n, 1)));
    coordinates.iter().map(point).collect()
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::elevated(&points(&[[0, 0], [3, 6], [9, 0]])),
        answer::elevated(&points(&[[7, 1]])),
    ]
}

/// The claim that the elevated polygon has these points.
fn compare(b: &[[i64; 2]], right: &[[i64; 2]]) {
    claim("the control points of one degree more")
        .input(format!("control points {b:?}"))
        .picture(|| {
            Picture::new()
                .given(points(b))
                .expected(points(right))
                .found(answer::elevated(&points(b)))
        })
        .equal(answer::elevated(&points(b)), points(right));
}

/// Why: the smallest case; the new point is the middle.
#[test]
fn a_segment() {
    compare(&[[0, 0], [4, 2]], &[[0, 0], [2, 1], [4, 2]]);
}

/// Why: the two inner points divide their legs in different ratios.
#[test]
fn a_parabola() {
    compare(&[[0, 0], [3, 6], [9, 0]], &[[0, 0], [2, 4], [5, 4], [9, 0]]);
}

/// Why: degree 0 is easily forgotten.
#[test]
fn a_single_point() {
    compare(&[[7, 1]], &[[7, 1], [7, 1]]);
}

proptest! {
    /// Why: it compares the curves and not the points, in every degree.
    #[test]
    fn the_curve_stays(b in prop::collection::vec(any::<[i8; 2]>(), 1..=6)) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let curve = BezierCurve::new(points(&b)).expect("at least one point");
        let found = answer::elevated(&points(&b));
        claim("the number of control points").equal(found.len(), b.len() + 1);
        let elevated = BezierCurve::new(found).expect("at least one point");
        // Polynomials of degree n + 1 that agree at n + 2 parameters are equal.
        for k in 0..=b.len() as i64 {
            let t = fraction(k, 4);
            claim(format!("the point of the elevated curve at t = {t}"))
                .picture(|| Picture::new().given(points(&b)).found(elevated.control_points().to_vec()))
                .equal(elevated.at(t.clone()), curve.at(t));
        }
    }
}
