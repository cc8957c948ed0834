//! The image of a point under the affine map of the plane that three images determine.

use cagd::affine::{Point, plane_determinant};
use cagd::scalar::Scalar;

/// The image of `m` under the affine map that sends each corner of the triangle to its image.
///
/// `None` if the three corners lie on a line.
pub fn image<T: Scalar>(
    corners: &[Point<T, 2>; 3],
    images: &[Point<T, 2>; 3],
    m: &Point<T, 2>,
) -> Option<Point<T, 2>> {
    //@ solution
    let [a, b, c] = corners;
    let double_area = |p: &Point<T, 2>, q: &Point<T, 2>, r: &Point<T, 2>| {
        plane_determinant(&(q.clone() - p.clone()), &(r.clone() - p.clone()))
    };
    let whole = double_area(a, b, c);
    if whole.is_zero() {
        return None;
    }
    let beta = double_area(a, m, c) / whole.clone();
    let gamma = double_area(a, b, m) / whole;
    let [a, b, c] = images;
    Some(a.clone() + (b.clone() - a.clone()) * beta + (c.clone() - a.clone()) * gamma)
    //@ starter
    //| // Two determinants are needed; here is how one is computed.
    //| let [a, b, c] = corners;
    //| let whole = plane_determinant(&(b.clone() - a.clone()), &(c.clone() - a.clone()));
    //| let _ = (m, whole);
    //| Some(images[0].clone())
    //@ end
}
