//! misconception: A leaves three equal numbers as they are, so all weights are equal; but that is a right eigenvector, and the weights are a left one

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of a vertex, and the derivative there.
pub fn limit<T: Scalar>(points: &[Point<T, 2>], i: usize) -> (Point<T, 2>, Vector<T, 2>) {
    let n = points.len();
    let (before, vertex, after) = (&points[(i + n - 1) % n], &points[i], &points[(i + 1) % n]);
    let to_before = before.clone() - vertex.clone();
    let to_after = after.clone() - vertex.clone();
    let point = vertex.clone() + (to_before + to_after) * T::from_ratio(1, 3);
    let derivative = (after.clone() - before.clone()) * T::from_ratio(1, 2);
    (point, derivative)
}
