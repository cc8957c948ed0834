//! misconception: to move a figure by w one subtracts w from the coordinates, as one does when the axes are moved

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// Touching point and direction of a tangent after a translation.
pub fn translated<T: Scalar>(
    point: &Point<T, 2>,
    direction: &Vector<T, 2>,
    by: &Vector<T, 2>,
) -> (Point<T, 2>, Vector<T, 2>) {
    (point.clone() - by.clone(), direction.clone())
}
