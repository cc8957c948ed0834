//! misconception: a crease vertex lies on the surface, so it is the mean of the smooth rule and of the rule of the curve; then it depends on what lies beside the crease

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
        2 => {
            let (smooth, curve) = (pull(&all, beta.clone()), pull(&sharp, T::from_ratio(1, 8)));
            smooth.clone() + (curve - smooth) * T::from_ratio(1, 2)
        }
        _ => v.clone(),
    }
}
