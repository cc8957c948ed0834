//! misconception: one interpolation between the ends is enough, the middle point does not matter

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The point b(t).
pub fn point<T: Scalar>(b: &[Point<T, 2>; 3], t: T) -> Point<T, 2> {
    b[0].clone() + (b[2].clone() - b[0].clone()) * t
}
