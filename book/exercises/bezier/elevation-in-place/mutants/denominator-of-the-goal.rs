//! misconception: all steps divide by the degree that is wanted in the end

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree m ≥ n of the curve of degree n with the control points b, at least one.
pub fn elevated_to<T: Scalar>(b: &[Point<T, 2>], m: usize) -> Vec<Point<T, 2>> {
    let mut points = b.to_vec();
    while points.len() <= m {
        let last = points.len();
        points.push(points[last - 1].clone());
        for i in (1..last).rev() {
            let weight = T::from_ratio(i as i64, m as i64);
            points[i] = points[i].lerp(&points[i - 1], weight);
        }
    }
    points
}
