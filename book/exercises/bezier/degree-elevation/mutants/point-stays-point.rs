//! misconception: a single point needs no second one, it is the same curve in every degree

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree n + 1 of the curve with the control points b, at least one.
pub fn elevated<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    let mut points = vec![b[0].clone()];
    for i in 1..=n {
        let weight = T::from_ratio(i as i64, n as i64 + 1);
        points.push(b[i].lerp(&b[i - 1], weight));
    }
    if n > 0 {
        points.push(b[n].clone());
    }
    points
}
