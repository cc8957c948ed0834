//! The limit position of a vertex under Loop's scheme.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The limit of the vertex `v` with these neighbours, in cyclic order, each of which has the weight `beta` in a step.
pub fn limit_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    beta: &T,
) -> Point<T, 3> {
    //@ solution
    let omega = T::from_ratio(3, 8) / beta.clone();
    let k = T::from_integer(neighbours.len() as i64);
    let sum = neighbours
        .iter()
        .fold(Vector::zeros(), |sum: Vector<T, 3>, n| {
            sum + (n.clone() - v.clone())
        });
    v.clone() + sum / (omega + k)
    //@ starter
    //| // This is right only if the vertex does not move.
    //| let _: (&[Point<T, 3>], &T, Option<Vector<T, 3>>) = (neighbours, beta, None);
    //| v.clone()
    //@ end
}
