//! misconception: a control point more changes nothing if it repeats the last one

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The control points of degree n + 1 of the curve with the control points b, at least one.
pub fn elevated<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    let mut points = b.to_vec();
    points.push(b[n].clone());
    points
}
