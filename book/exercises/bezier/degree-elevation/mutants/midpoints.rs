//! misconception: corner cutting takes the middle of each leg

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree n + 1 of the curve with the control points b, at least one.
pub fn elevated<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    let mut points = vec![b[0].clone()];
    for i in 1..=n {
        let weight = T::from_ratio(1, 2);
        points.push(b[i].lerp(&b[i - 1], weight));
    }
    points.push(b[n].clone());
    points
}
