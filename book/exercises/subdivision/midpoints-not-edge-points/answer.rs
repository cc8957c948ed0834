//! The vertex point of Catmull–Clark subdivision.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The new place of the vertex `v` with these neighbours, in cyclic order.
///
/// `face_points[j]` is the mean of the vertices of the face between the neighbours j and j + 1.
/// Both lists have the same length, three or more.
pub fn vertex_point<T: Scalar>(
    v: &Point<T, 3>,
    neighbours: &[Point<T, 3>],
    face_points: &[Point<T, 3>],
) -> Point<T, 3> {
    let k = neighbours.len();
    let count = T::from_integer(k as i64);
    // All vectors begin in v.
    let to = |point: &Point<T, 3>| point.clone() - v.clone();
    let mut faces = Vector::zeros();
    let mut edges = Vector::zeros();
    for j in 0..k {
        //@ solution
        let edge = to(&neighbours[j]) * T::from_ratio(1, 2);
        //@ starter
        //| let before = to(&face_points[(j + k - 1) % k]);
        //| let edge = (to(&neighbours[j]) + before + to(&face_points[j])) * T::from_ratio(1, 4);
        //@ end
        faces += to(&face_points[j]);
        edges += edge;
    }
    let mean = |sum: Vector<T, 3>| sum / count.clone();
    // (F + 2R + (k − 3) v)/k, seen from v.
    v.clone() + (mean(faces) + mean(edges) * T::from_integer(2)) / count.clone()
}
