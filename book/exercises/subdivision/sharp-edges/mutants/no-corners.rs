//! misconception: each neighbour at a sharp edge pulls with 1/8, however many there are; where creases meet, nothing may move

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
        0 | 1 => pull(&all, beta.clone()),
        _ => pull(&sharp, T::from_ratio(1, 8)),
    }
}
