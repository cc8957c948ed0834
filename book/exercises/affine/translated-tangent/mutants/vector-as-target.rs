//! misconception: the vector of a translation says where the point goes, not how far

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// Touching point and direction of a tangent after a translation.
pub fn translated<T: Scalar>(
    point: &Point<T, 2>,
    direction: &Vector<T, 2>,
    by: &Vector<T, 2>,
) -> (Point<T, 2>, Vector<T, 2>) {
    let _ = point;
    (Point::origin() + by.clone(), direction.clone())
}
