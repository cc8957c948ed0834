//! What a translation does to a tangent.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// Touching point and direction of a tangent after the translation by `by`.
///
/// The tangent touches at `point` and runs in the direction `direction`.
pub fn translated<T: Scalar>(
    point: &Point<T, 2>,
    direction: &Vector<T, 2>,
    by: &Vector<T, 2>,
) -> (Point<T, 2>, Vector<T, 2>) {
    //@ solution
    (point.clone() + by.clone(), direction.clone())
    //@ starter
    //| // The moved tangent should be parallel to the given one, but it is not.
    //| (point.clone() + by.clone(), direction + by)
    //@ end
}
