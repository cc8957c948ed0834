//! Forwards, with the value that is overwritten kept in a variable.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree m ≥ n of the curve of degree n with the control points b, at least one.
pub fn elevated_to<T: Scalar>(b: &[Point<T, 2>], m: usize) -> Vec<Point<T, 2>> {
    let mut points = b.to_vec();
    while points.len() <= m {
        let degree = points.len();
        points.push(points[degree - 1].clone());
        let mut before = points[0].clone();
        for (i, point) in points.iter_mut().enumerate().take(degree).skip(1) {
            let weight = T::from_ratio(i as i64, degree as i64);
            let new = point.lerp(&before, weight);
            before = std::mem::replace(point, new);
        }
    }
    points
}
