//! The new face inside a face, by Doo and Sabin.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new vertices at the vertices of `face`, in the same order.
///
/// `cosines[j]` is cos(2πj/k), where k ≥ 3 is the number of vertices.
pub fn new_face<T: Scalar>(face: &[Point<T, 2>], cosines: &[T]) -> Vec<Point<T, 2>> {
    let k = face.len();
    let four_k = T::from_integer(4 * k as i64);
    //@ solution
    let weight =
        |j: usize| (T::from_integer(3) + T::from_integer(2) * cosines[j].clone()) / four_k.clone();
    let new_vertex = |i: usize| {
        (1..k).fold(face[i].clone(), |sum, j| {
            sum + (face[(i + j) % k].clone() - face[i].clone()) * weight(j)
        })
    };
    (0..k).map(new_vertex).collect()
    //@ starter
    //| // Nothing shrinks yet.
    //| let _ = (cosines, four_k);
    //| face.to_vec()
    //@ end
}
