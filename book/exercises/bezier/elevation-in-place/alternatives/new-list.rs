//! A new list for every step.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree m ≥ n of the curve of degree n with the control points b, at least one.
pub fn elevated_to<T: Scalar>(b: &[Point<T, 2>], m: usize) -> Vec<Point<T, 2>> {
    let mut points = b.to_vec();
    for degree in b.len()..=m {
        let inner = (1..degree).map(|i| {
            let weight = T::from_ratio(i as i64, degree as i64);
            points[i].lerp(&points[i - 1], weight)
        });
        let first = points.first().cloned();
        let last = points.last().cloned();
        points = first.into_iter().chain(inner).chain(last).collect();
    }
    points
}
