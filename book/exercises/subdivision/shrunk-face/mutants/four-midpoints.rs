//! misconception: the new vertex is the mean of the vertex, the midpoints of its two edges and the centroid; but that is so for quadrilaterals only

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new vertices at the vertices of `face`.
pub fn new_face<T: Scalar>(face: &[Point<T, 2>], cosines: &[T]) -> Vec<Point<T, 2>> {
    let k = face.len();
    let four_k = T::from_integer(4 * k as i64);
    let _ = cosines;
    let new_vertex = |i: usize| {
        let to = |j: usize| face[j % k].clone() - face[i].clone();
        let eighth = T::from_ratio(1, 8);
        let sides = face[i].clone() + to(i + 1) * eighth.clone() + to(i + k - 1) * eighth;
        (0..k).fold(sides, |sum, j| sum + to(j) / four_k.clone())
    };
    (0..k).map(new_vertex).collect()
}
