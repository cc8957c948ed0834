//! misconception: a single sharp edge already holds the vertex; but a crease may end inside a smooth surface, in a dart

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The new place of the vertex `v`.
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
    let tagged = ring.iter().filter(|(_, sharp)| *sharp);
    let sharp: Vec<&Point<T, 3>> = tagged.map(|(point, _)| point).collect();
    match sharp.len() {
        0 => pull(&all, beta.clone()),
        2 => pull(&sharp, T::from_ratio(1, 8)),
        _ => v.clone(),
    }
}
