//! misconception: the displacement runs from the point to the centre, so the figure is stretched to the other side

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The stretched point.
pub fn stretched<T: Scalar>(point: &Point<T, 2>, centre: &Point<T, 2>, factor: T) -> Point<T, 2> {
    centre.clone() + (centre.clone() - point.clone()) * factor
}
