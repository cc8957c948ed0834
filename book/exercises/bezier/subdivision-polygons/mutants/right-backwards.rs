//! misconception: the right polygon comes in the order in which the algorithm finds it, so the piece runs back from b(1)

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of the left piece and of the right piece of the curve with the control points b, cut at α.
pub fn subdivided<T: Scalar>(b: &[Point<T, 2>], alpha: T) -> [Vec<Point<T, 2>>; 2] {
    let mut column = b.to_vec();
    let mut left = Vec::new();
    let mut right = Vec::new();
    for _ in 0..b.len() {
        left.push(column[0].clone());
        right.push(column[column.len() - 1].clone());
        column = column
            .windows(2)
            .map(|pair| pair[0].lerp(&pair[1], alpha.clone()))
            .collect();
    }
    [left, right]
}
