//! misconception: each leg is cut to its part between c and d, as if the polygon were the curve

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of t ↦ b((1 − t)c + td) for the curve with the control points b, at least one.
pub fn points_over<T: Scalar>(b: &[Point<T, 2>], c: T, d: T) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    if n == 0 {
        return b.to_vec();
    }
    let mut points = vec![b[0].lerp(&b[1], c)];
    points.extend(b[1..n].iter().cloned());
    points.push(b[n - 1].lerp(&b[n], d));
    points
}
