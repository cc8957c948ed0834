//! A stretching from a centre.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The point whose displacement from `centre` is `factor` times that of `point`.
pub fn stretched<T: Scalar>(point: &Point<T, 2>, centre: &Point<T, 2>, factor: T) -> Point<T, 2> {
    //@ solution
    centre.clone() + (point.clone() - centre.clone()) * factor
    //@ starter
    //| // This is the point for factor 1 only.
    //| let _ = (centre, factor);
    //| point.clone()
    //@ end
}
