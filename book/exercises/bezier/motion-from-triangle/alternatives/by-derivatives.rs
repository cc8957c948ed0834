//! The derivative as a curve, twice.

use cagd::affine::{Point, Vector};
use cagd::bezier::BezierCurve;
use cagd::scalar::Scalar;

/// The velocity and the acceleration at u of a curve of degree n ≥ 2.
pub fn motion<T: Scalar>(curve: &BezierCurve<Point<T, 2>>, u: T) -> [Vector<T, 2>; 2] {
    let velocity = curve.derivative();
    let acceleration = velocity.derivative();
    [velocity.at(u.clone()), acceleration.at(u)]
}
