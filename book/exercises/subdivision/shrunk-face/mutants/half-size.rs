//! misconception: a face becomes half as large, from its centroid; but that is so for triangles and parallelograms only

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new vertices at the vertices of `face`.
pub fn new_face<T: Scalar>(face: &[Point<T, 2>], cosines: &[T]) -> Vec<Point<T, 2>> {
    let k = face.len();
    let _ = cosines;
    let new_vertex = |i: usize| {
        let share = T::from_ratio(1, 2 * k as i64);
        (0..k).fold(face[i].clone(), |sum, j| {
            sum + (face[j].clone() - face[i].clone()) * share.clone()
        })
    };
    (0..k).map(new_vertex).collect()
}
