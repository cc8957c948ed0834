//! misconception: twice a point is the point with twice its coordinates, wherever the centre is

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The stretched point.
pub fn stretched<T: Scalar>(point: &Point<T, 2>, centre: &Point<T, 2>, factor: T) -> Point<T, 2> {
    let _ = centre;
    Point::origin() + point.from_origin() * factor
}
