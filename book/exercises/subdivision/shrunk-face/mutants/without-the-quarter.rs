//! misconception: one formula serves all j; but at j = 0 a quarter must be added, and here the weights are divided by their sum 3/4 instead

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new vertices at the vertices of `face`.
pub fn new_face<T: Scalar>(face: &[Point<T, 2>], cosines: &[T]) -> Vec<Point<T, 2>> {
    let k = face.len();
    let four_k = T::from_integer(4 * k as i64);
    let weight =
        |j: usize| (T::from_integer(3) + T::from_integer(2) * cosines[j].clone()) / four_k.clone();
    let factor = T::from_ratio(4, 3);
    let new_vertex = |i: usize| {
        (1..k).fold(face[i].clone(), |sum, j| {
            let to = face[(i + j) % k].clone() - face[i].clone();
            sum + to * weight(j) * factor.clone()
        })
    };
    (0..k).map(new_vertex).collect()
}
