//! The derivative of a Bézier curve, by its control vectors.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The control vectors of the derivative of the curve with the control points b, at least one.
pub fn control_vectors<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Vector<T, 2>> {
    //@ solution
    let n = b.len() as i64 - 1;
    if n == 0 {
        return vec![Vector::zeros()];
    }
    b.windows(2)
        .map(|leg| (leg[1].clone() - leg[0].clone()) * T::from_integer(n))
        .collect()
    //@ starter
    //| // This is right for a curve that stands still.
    //| let _ = b;
    //| vec![Vector::zeros()]
    //@ end
}
