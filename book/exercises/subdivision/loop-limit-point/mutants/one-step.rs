//! misconception: the vertex reaches its limit after one step; but its neighbours move, too, and pull it further

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of the vertex.
pub fn limit_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    beta: &T,
) -> Point<T, 3> {
    let sum = neighbours
        .iter()
        .fold(Vector::zeros(), |sum: Vector<T, 3>, n| {
            sum + (n.clone() - v.clone())
        });
    v.clone() + sum * beta.clone()
}
