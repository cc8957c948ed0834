//! misconception: only the coefficient sum 1 has a meaning

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// What a weighted sum of two points is.
pub enum Sum<T: Scalar> {
    /// A position.
    Point(Point<T, 2>),
    /// A displacement.
    Vector(Vector<T, 2>),
    /// Neither.
    Nothing,
}

/// The weighted sum.
pub fn weighted_sum<T: Scalar>(alpha: T, a: &Point<T, 2>, beta: T, b: &Point<T, 2>) -> Sum<T> {
    if (alpha + beta.clone()).is_one() {
        Sum::Point(a.clone() + (b.clone() - a.clone()) * beta)
    } else {
        Sum::Nothing
    }
}
