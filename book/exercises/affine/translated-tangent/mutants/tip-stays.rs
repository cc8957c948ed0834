//! misconception: the tip of the arrow stays where it is, so the direction must shrink by what the point has moved

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// Touching point and direction of a tangent after a translation.
pub fn translated<T: Scalar>(
    point: &Point<T, 2>,
    direction: &Vector<T, 2>,
    by: &Vector<T, 2>,
) -> (Point<T, 2>, Vector<T, 2>) {
    (point.clone() + by.clone(), direction - by)
}
