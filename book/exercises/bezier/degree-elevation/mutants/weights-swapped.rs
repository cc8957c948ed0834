//! misconception: the weight of the point before is 1 − i/(n + 1), so the points begin at the wrong end of the leg

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree n + 1 of the curve with the control points b, at least one.
pub fn elevated<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    let mut points = vec![b[0].clone()];
    for i in 1..=n {
        let weight = T::from_ratio((n + 1 - i) as i64, n as i64 + 1);
        points.push(b[i].lerp(&b[i - 1], weight));
    }
    points.push(b[n].clone());
    points
}
