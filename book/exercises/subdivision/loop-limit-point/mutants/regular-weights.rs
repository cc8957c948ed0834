//! misconception: the weights 6 and 1 of the regular case serve every valence; but 6 is 3/(8β) for β = 1/16 alone

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of the vertex.
pub fn limit_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    beta: &T,
) -> Point<T, 3> {
    let _ = beta;
    let k = T::from_integer(neighbours.len() as i64);
    let sum = neighbours
        .iter()
        .fold(Vector::zeros(), |sum: Vector<T, 3>, n| {
            sum + (n.clone() - v.clone())
        });
    v.clone() + sum / (T::from_integer(6) + k)
}
