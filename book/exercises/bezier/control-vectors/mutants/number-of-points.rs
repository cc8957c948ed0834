//! misconception: the factor is the number of control points; but n + 1 points have n legs, and the degree is n

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The control vectors of the derivative of the curve with the control points b, at least one.
pub fn control_vectors<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Vector<T, 2>> {
    if b.len() == 1 {
        return vec![Vector::zeros()];
    }
    let n = b.len() as i64;
    b.windows(2)
        .map(|leg| (leg[1].clone() - leg[0].clone()) * T::from_integer(n))
        .collect()
}
