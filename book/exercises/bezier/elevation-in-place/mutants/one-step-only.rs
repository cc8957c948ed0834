//! misconception: one elevation is enough, and the goal is reached by repeating the last point

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree m ≥ n of the curve of degree n with the control points b, at least one.
pub fn elevated_to<T: Scalar>(b: &[Point<T, 2>], m: usize) -> Vec<Point<T, 2>> {
    let mut points = b.to_vec();
    let n = b.len() - 1;
    if m > n {
        points.push(points[n].clone());
        for i in (1..=n).rev() {
            let weight = T::from_ratio(i as i64, n as i64 + 1);
            points[i] = points[i].lerp(&points[i - 1], weight);
        }
    }
    while points.len() <= m {
        points.push(b[n].clone());
    }
    points
}
