//! misconception: the control vectors are the legs of the polygon themselves; the degree plays no part

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The control vectors of the derivative of the curve with the control points b, at least one.
pub fn control_vectors<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Vector<T, 2>> {
    if b.len() == 1 {
        return vec![Vector::zeros()];
    }
    b.windows(2)
        .map(|leg| leg[1].clone() - leg[0].clone())
        .collect()
}
