//! misconception: the rule is (F + 2R + v)/4, as on a grid, whatever the valence is; but it is divided by k, and v counts k − 3 times

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The new place of the vertex `v`.
pub fn vertex_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    face_points: &[Point<T, 3>],
) -> Point<T, 3> {
    let count = T::from_integer(neighbours.len() as i64);
    let mean = |points: &[Point<T, 3>]| {
        let sum = points.iter().fold(Vector::zeros(), |sum: Vector<T, 3>, p| {
            sum + (p.clone() - v.clone())
        });
        sum / count.clone()
    };
    let (faces, neighbours) = (mean(face_points), mean(neighbours));
    v.clone() + (faces + neighbours) * T::from_ratio(1, 4)
}
