//! misconception: areas are never negative

use cagd::affine::{Point, plane_determinant};
use cagd::scalar::OrderedScalar;

/// The image of `m`.
pub fn image<T: OrderedScalar>(
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
    let beta = (double_area(a, m, c) / whole.clone()).abs();
    let gamma = (double_area(a, b, m) / whole).abs();
    let [a, b, c] = images;
    Some(a.clone() + (b.clone() - a.clone()) * beta + (c.clone() - a.clone()) * gamma)
}
