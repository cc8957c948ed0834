//! In place: what is left of the list in the end is the right polygon.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of the left piece and of the right piece of the curve with the control points b, cut at α.
pub fn subdivided<T: Scalar>(b: &[Point<T, 2>], alpha: T) -> [Vec<Point<T, 2>>; 2] {
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
