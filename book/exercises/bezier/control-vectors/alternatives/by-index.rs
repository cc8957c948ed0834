//! The same with indices; the empty list is replaced at the end.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The control vectors of the derivative of the curve with the control points b, at least one.
pub fn control_vectors<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Vector<T, 2>> {
    let n = b.len() - 1;
    let mut vectors = Vec::new();
    for i in 0..n {
        let leg = b[i + 1].clone() - b[i].clone();
        vectors.push(leg * T::from_integer(n as i64));
    }
    if vectors.is_empty() {
        vectors.push(Vector::zeros());
    }
    vectors
}
