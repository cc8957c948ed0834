//! The vertex point of Loop's scheme with sharp edges.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The new place of the vertex `v`.
///
/// `ring` holds its neighbours in cyclic order, each with whether the edge to it is sharp.
/// `beta` is the weight of a neighbour if the vertex is smooth.
pub fn vertex_point<T: Scalar>(
    v: &Point<T, 3>,
    ring: &[(Point<T, 3>, bool)],
    beta: &T,
) -> Point<T, 3> {
    let pull = |points: &[&Point<T, 3>], weight: T| {
        let vectors = points.iter().map(|&p| p.clone() - v.clone());
        v.clone() + vectors.fold(Vector::zeros(), |sum: Vector<T, 3>, to| sum + to) * weight
    };
    let all: Vec<&Point<T, 3>> = ring.iter().map(|(point, _)| point).collect();
    //@ solution
    let sharp: Vec<&Point<T, 3>> = ring
        .iter()
        .filter(|(_, sharp)| *sharp)
        .map(|(point, _)| point)
        .collect();
    match sharp.len() {
        0 | 1 => pull(&all, beta.clone()),
        2 => pull(&sharp, T::from_ratio(1, 8)),
        _ => v.clone(),
    }
    //@ starter
    //| // The tags are not asked yet.
    //| pull(&all, beta.clone())
    //@ end
}
