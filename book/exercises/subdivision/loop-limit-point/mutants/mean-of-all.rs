//! misconception: all points meet in the middle, so the limit is the mean of the vertex and its neighbours; but a step changes this mean

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of the vertex.
pub fn limit_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    beta: &T,
) -> Point<T, 3> {
    let _ = beta;
    let count = T::from_integer(neighbours.len() as i64 + 1);
    let sum = neighbours
        .iter()
        .fold(Vector::zeros(), |sum: Vector<T, 3>, n| {
            sum + (n.clone() - v.clone())
        });
    v.clone() + sum / count
}
