//! misconception: cut at d, then cut the left piece at c; but that piece runs from 0 to d, and c is not its parameter

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The left and the right polygon of a subdivision.
fn subdivided<T: Scalar>(b: &[Point<T, 2>], alpha: &T) -> [Vec<Point<T, 2>>; 2] {
    let mut right = b.to_vec();
    let mut left = Vec::new();
    for last in (0..b.len()).rev() {
        left.push(right[0].clone());
        for i in 0..last {
            right[i] = right[i].lerp(&right[i + 1], alpha.clone());
        }
    }
    [left, right]
}

/// The control points of t ↦ b((1 − t)c + td) for the curve with the control points b, at least one.
pub fn points_over<T: Scalar>(b: &[Point<T, 2>], c: T, d: T) -> Vec<Point<T, 2>> {
    let [left, _] = subdivided(b, &d);
    let [_, right] = subdivided(&left, &c);
    right
}
