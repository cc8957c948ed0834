//! Degree elevation.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree n + 1 of the curve with the control points b, at least one.
pub fn elevated<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    let mut points = vec![b[0].clone()];
    //@ solution
    for i in 1..=n {
        let weight = T::from_ratio(i as i64, n as i64 + 1);
        points.push(b[i].lerp(&b[i - 1], weight));
    }
    //@ starter
    //| for i in 1..=n {
    //|     // This is the start of the leg; the new point is elsewhere on it.
    //|     points.push(b[i - 1].lerp(&b[i], T::zero()));
    //| }
    //@ end
    points.push(b[n].clone());
    points
}
