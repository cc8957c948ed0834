//! misconception: the point is moved on by λ times its displacement, so λ = 1 doubles the distance

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The stretched point.
pub fn stretched<T: Scalar>(point: &Point<T, 2>, centre: &Point<T, 2>, factor: T) -> Point<T, 2> {
    point.clone() + (point.clone() - centre.clone()) * factor
}
