//! Points with all their derivatives.

use cagd::affine::Affine;
use cagd::bezier::BezierCurve;

/// The point b(u) and the derivatives of order 1 to n at u, one hodograph after the other.
pub fn jet<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> (P, Vec<P::Difference>) {
    let hodographs = std::iter::successors(Some(curve.derivative()), |hodograph| {
        Some(hodograph.derivative())
    });
    let derivatives = hodographs
        .take(curve.degree())
        .map(|hodograph| hodograph.at(u.clone()));
    (curve.at(u.clone()), derivatives.collect())
}
