//! misconception: the point and the centre change their roles, so the centre is stretched from the point

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The stretched point.
pub fn stretched<T: Scalar>(point: &Point<T, 2>, centre: &Point<T, 2>, factor: T) -> Point<T, 2> {
    point.clone() + (centre.clone() - point.clone()) * factor
}
