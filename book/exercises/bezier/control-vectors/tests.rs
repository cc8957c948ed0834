use cagd::affine::{Point, Vector};
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

fn vectors(coordinates: &[[i64; 2]]) -> Vec<Vector<BigRational, 2>> {
    let vector = |xy: &[i64; 2]| Vector::from(xy.map(number));
    coordinates.iter().map(vector).collect()
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::control_vectors(&points(&[[0, 0], [1, 3], [4, 3], [5, 0]])),
        answer::control_vectors(&points(&[[7, 1]])),
    ]
}

/// The claim that the answer gives these vectors.
fn compare(b: &[[i64; 2]], right: Vec<Vector<BigRational, 2>>) {
    let origin = || Point::<BigRational, 2>::origin();
    let arrows = |vectors: Vec<Vector<BigRational, 2>>| {
        let ends: Vec<_> = vectors.into_iter().map(|v| origin() + v).collect();
        ends
    };
    claim("the control vectors of the derivative")
        .input(format!("control points {b:?}"))
        .picture(|| {
            // The hodograph: control vectors drawn from the origin.
            Picture::new()
                .given(points(b))
                .expected(arrows(right.clone()))
                .found(arrows(answer::control_vectors(&points(b))))
        })
        .equal(answer::control_vectors(&points(b)), right.clone());
}

/// Why: the smallest case; the factor is 1, so only the direction can be wrong.
#[test]
fn a_segment() {
    compare(&[[1, 2], [4, 6]], vectors(&[[3, 4]]));
}

/// Why: three legs that can be subtracted by hand.
#[test]
fn a_cubic() {
    compare(
        &[[0, 0], [1, 3], [4, 3], [5, 0]],
        vectors(&[[3, 9], [9, 0], [3, -9]]),
    );
}

/// Why: degree 0 is easily forgotten.
#[test]
fn a_single_point() {
    compare(&[[7, 1]], vectors(&[[0, 0]]));
}

/// Why: repeated points give the vector 0 in between, which must not be left out.
#[test]
fn repeated_points() {
    compare(
        &[[0, 0], [2, 2], [2, 2], [3, 0]],
        vectors(&[[6, 6], [0, 0], [3, -6]]),
    );
}

proptest! {
    /// Why: it rejects what is right for special polygons only.
    #[test]
    fn every_curve(b in prop::collection::vec(any::<[i8; 2]>(), 1..=7)) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let curve = BezierCurve::new(points(&b)).expect("at least one point");
        compare(&b, curve.derivative().control_points().to_vec());
    }
}
