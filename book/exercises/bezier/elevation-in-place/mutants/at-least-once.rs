//! misconception: an elevation always makes a step, and whether the degree is reached is asked afterwards

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree m ≥ n of the curve of degree n with the control points b, at least one.
pub fn elevated_to<T: Scalar>(b: &[Point<T, 2>], m: usize) -> Vec<Point<T, 2>> {
    let mut points = b.to_vec();
    loop {
        let next_degree = points.len();
        points.push(points[next_degree - 1].clone());
        for i in (1..next_degree).rev() {
            let weight = T::from_ratio(i as i64, next_degree as i64);
            points[i] = points[i].lerp(&points[i - 1], weight);
        }
        if points.len() > m {
            return points;
        }
    }
}
