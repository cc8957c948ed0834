//! misconception: a translation adds its vector to vectors, and the point where the tangent touches stays

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// Touching point and direction of a tangent after a translation.
pub fn translated<T: Scalar>(
    point: &Point<T, 2>,
    direction: &Vector<T, 2>,
    by: &Vector<T, 2>,
) -> (Point<T, 2>, Vector<T, 2>) {
    (point.clone(), direction + by)
}
