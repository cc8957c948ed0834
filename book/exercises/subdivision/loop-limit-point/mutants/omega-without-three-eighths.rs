//! misconception: the weight of the vertex is 1/β; but the factor 3/8, by which the vertex pulls its neighbours, is forgotten

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of the vertex.
pub fn limit_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    beta: &T,
) -> Point<T, 3> {
    let omega = T::one() / beta.clone();
    let k = T::from_integer(neighbours.len() as i64);
    let sum = neighbours
        .iter()
        .fold(Vector::zeros(), |sum: Vector<T, 3>, n| {
            sum + (n.clone() - v.clone())
        });
    v.clone() + sum / (omega + k)
}
