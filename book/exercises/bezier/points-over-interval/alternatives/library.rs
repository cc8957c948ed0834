//! The library's blossom.

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::scalar::Scalar;

/// The control points of t ↦ b((1 − t)c + td) for the curve with the control points b, at least one.
pub fn points_over<T: Scalar>(b: &[Point<T, 2>], c: T, d: T) -> Vec<Point<T, 2>> {
    let curve = BezierCurve::new(b.to_vec()).expect("at least one point");
    let (blossom, n) = (curve.blossom(), curve.degree());
    let value = |ends: usize| {
        let mut arguments = vec![c.clone(); n];
        arguments[n - ends..].fill(d.clone());
        blossom.at(&arguments).expect("n numbers")
    };
    (0..=n).map(value).collect()
}
