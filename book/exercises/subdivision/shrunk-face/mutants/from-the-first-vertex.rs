//! misconception: the weight γⱼ belongs to vⱼ for every new vertex; but it belongs to the j-th vertex counted from vᵢ

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new vertices at the vertices of `face`.
pub fn new_face<T: Scalar>(face: &[Point<T, 2>], cosines: &[T]) -> Vec<Point<T, 2>> {
    let k = face.len();
    let four_k = T::from_integer(4 * k as i64);
    let weight =
        |j: usize| (T::from_integer(3) + T::from_integer(2) * cosines[j].clone()) / four_k.clone();
    let new_vertex = |i: usize| {
        let origin = face[i].clone();
        (1..k).fold(origin.clone(), |sum, j| {
            sum + (face[j].clone() - origin.clone()) * weight(j)
        })
    };
    (0..k).map(new_vertex).collect()
}
