//! misconception: the first coefficient says how far to go from A to B

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
    let way = (b.clone() - a.clone()) * alpha.clone();
    let sum = alpha + beta;
    if sum.is_one() {
        Sum::Point(a.clone() + way)
    } else if sum.is_zero() {
        Sum::Vector(way)
    } else {
        Sum::Nothing
    }
}
