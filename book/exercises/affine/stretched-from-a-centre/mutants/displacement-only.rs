//! misconception: the stretched displacement is already the point, so it need not be put back at the centre

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The stretched point.
pub fn stretched<T: Scalar>(point: &Point<T, 2>, centre: &Point<T, 2>, factor: T) -> Point<T, 2> {
    Point::origin() + (point.clone() - centre.clone()) * factor
}
