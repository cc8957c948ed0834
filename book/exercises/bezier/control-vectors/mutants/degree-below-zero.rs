//! misconception: a point has no leg, so its derivative has no control vector at all

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The control vectors of the derivative of the curve with the control points b, at least one.
pub fn control_vectors<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Vector<T, 2>> {
    let n = b.len() as i64 - 1;
    b.windows(2)
        .map(|leg| (leg[1].clone() - leg[0].clone()) * T::from_integer(n))
        .collect()
}
