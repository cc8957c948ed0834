//! The limit of a vertex of the cubic scheme.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of the vertex number `i` of a closed polygon, and the derivative there.
///
/// `points` is not empty, and `i` is one of its indices.
pub fn limit<T: Scalar>(points: &[Point<T, 2>], i: usize) -> (Point<T, 2>, Vector<T, 2>) {
    let n = points.len();
    let (before, vertex, after) = (&points[(i + n - 1) % n], &points[i], &points[(i + 1) % n]);
    //@ solution
    let to_before = before.clone() - vertex.clone();
    let to_after = after.clone() - vertex.clone();
    let point = vertex.clone() + (to_before + to_after) * T::from_ratio(1, 6);
    let derivative = (after.clone() - before.clone()) * T::from_ratio(1, 2);
    (point, derivative)
    //@ starter
    //| // Where the vertex is before the first step, and the way from one neighbour to the other.
    //| (vertex.clone(), after.clone() - before.clone())
    //@ end
}
