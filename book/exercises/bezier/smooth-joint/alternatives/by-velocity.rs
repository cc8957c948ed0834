//! The library's derivative gives the velocity at the end of the first piece.

use cagd::affine::{Interval, Point};
use cagd::bezier::BezierCurve;
use cagd::scalar::Scalar;

/// The points c₀ and c₁ of the second piece, of degree m, for a C¹ joint.
pub fn joint<T: Scalar>(b: &[Point<T, 2>], lengths: [T; 2], m: usize) -> [Point<T, 2>; 2] {
    let [h0, h1] = lengths;
    let domain = Interval::new(T::zero(), h0.clone()).expect("a positive length");
    let first = BezierCurve::on(domain, b.to_vec()).expect("at least two points");
    let velocity = first.derivative().at(h0.clone());
    let start = first.at(h0);
    [
        start.clone(),
        start + velocity * (h1 / T::from_integer(m as i64)),
    ]
}
