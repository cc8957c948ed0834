//! misconception: coefficients with another sum are divided by their sum first, so every sum but 0 gives a point

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
    let sum = alpha + beta.clone();
    if sum.is_zero() {
        return Sum::Vector((b.clone() - a.clone()) * beta);
    }
    Sum::Point(a.clone() + (b.clone() - a.clone()) * (beta / sum))
}
