//! The kinds of weighted sums of two points.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// What a weighted sum of two points is.
pub enum Sum<T: Scalar> {
    /// A position.
    Point(Point<T, 2>),
    /// A displacement.
    Vector(Vector<T, 2>),
    /// Neither: it would change with the origin.
    Nothing,
}

/// The sum `alpha`·`a` + `beta`·`b`.
pub fn weighted_sum<T: Scalar>(alpha: T, a: &Point<T, 2>, beta: T, b: &Point<T, 2>) -> Sum<T> {
    //@ solution
    let way = (b.clone() - a.clone()) * beta.clone();
    let sum = alpha + beta;
    if sum.is_one() {
        Sum::Point(a.clone() + way)
    } else if sum.is_zero() {
        Sum::Vector(way)
    } else {
        Sum::Nothing
    }
    //@ starter
    //| // This is the sum for the coefficients 0 and 1 only.
    //| let _ = (alpha, a, beta);
    //| Sum::Point(b.clone())
    //@ end
}
