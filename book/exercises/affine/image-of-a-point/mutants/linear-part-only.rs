//! misconception: the vectors B − A and C − A go to B′ − A′ and C′ − A′, and that is all, so A itself stays

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
    let beta = double_area(a, m, c) / whole.clone();
    let gamma = double_area(a, b, m) / whole;
    let [p, q, r] = images;
    Some(a.clone() + (q.clone() - p.clone()) * beta + (r.clone() - p.clone()) * gamma)
}
