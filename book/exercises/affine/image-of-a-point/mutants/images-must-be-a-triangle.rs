//! misconception: an affine map has an inverse, so images on a line are not allowed

use cagd::affine::{Point, plane_determinant};
use cagd::scalar::Scalar;

/// The image of `m`.
pub fn image<T: Scalar>(
    corners: &[Point<T, 2>; 3],
    images: &[Point<T, 2>; 3],
    m: &Point<T, 2>,
) -> Option<Point<T, 2>> {
    let [a, b, c] = corners;
    let double_area = |p: &Point<T, 2>, q: &Point<T, 2>, r: &Point<T, 2>| {
        plane_determinant(&(q.clone() - p.clone()), &(r.clone() - p.clone()))
    };
    let whole = double_area(a, b, c);
    if whole.is_zero() {
        return None;
    }
    let [p, q, r] = images;
    if double_area(p, q, r).is_zero() {
        return None;
    }
    let beta = double_area(a, m, c) / whole.clone();
    let gamma = double_area(a, b, m) / whole;
    let [a, b, c] = images;
    Some(a.clone() + (b.clone() - a.clone()) * beta + (c.clone() - a.clone()) * gamma)
}
