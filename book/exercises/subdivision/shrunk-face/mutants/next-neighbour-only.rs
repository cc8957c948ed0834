//! misconception: as with Chaikin each corner is cut at a quarter, with 3/4 of the vertex and 1/4 of the next one; but all vertices of the face have a weight

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new vertices at the vertices of `face`.
pub fn new_face<T: Scalar>(face: &[Point<T, 2>], cosines: &[T]) -> Vec<Point<T, 2>> {
    let k = face.len();
    let _ = cosines;
    let new_vertex = |i: usize| {
        let quarter = T::from_ratio(1, 4);
        face[i].clone() + (face[(i + 1) % k].clone() - face[i].clone()) * quarter
    };
    (0..k).map(new_vertex).collect()
}
