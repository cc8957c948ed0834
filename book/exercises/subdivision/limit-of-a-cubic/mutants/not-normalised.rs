//! misconception: an eigenvector may have any length, so (−1, 0, 1) gives the derivative; but for the points pⱼ = j it gives 2 instead of 1

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of a vertex, and the derivative there.
pub fn limit<T: Scalar>(points: &[Point<T, 2>], i: usize) -> (Point<T, 2>, Vector<T, 2>) {
    let n = points.len();
    let (before, vertex, after) = (&points[(i + n - 1) % n], &points[i], &points[(i + 1) % n]);
    let to_before = before.clone() - vertex.clone();
    let to_after = after.clone() - vertex.clone();
    let point = vertex.clone() + (to_before + to_after) * T::from_ratio(1, 6);
    let derivative = (after.clone() - before.clone()) * T::from_ratio(1, 1);
    (point, derivative)
}
