//! The limit position of a vertex under Loop's scheme.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of the vertex `v` with these neighbours, in cyclic order, each of which has the weight `beta` in a step.
pub fn limit_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    beta: &T,
) -> Point<T, 3> {
    let k = T::from_integer(neighbours.len() as i64);
    // The sum of the vectors from the vertex to its neighbours.
    let sum = neighbours
        .iter()
        .fold(Vector::zeros(), |sum: Vector<T, 3>, n| {
            sum + (n.clone() - v.clone())
        });
    //@ solution
    let omega = T::from_ratio(3, 8) / beta.clone();
    v.clone() + sum / (omega + k)
    //@ starter
    //| // The mean of the neighbours: the vertex itself has no weight yet.
    //| let _ = beta;
    //| v.clone() + sum / k
    //@ end
}
