//! misconception: the old control points stay, and the new point b(α) is put between them

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of the left piece and of the right piece of the curve with the control points b, cut at α.
pub fn subdivided<T: Scalar>(b: &[Point<T, 2>], alpha: T) -> [Vec<Point<T, 2>>; 2] {
    let mut column = b.to_vec();
    while column.len() > 1 {
        column = column
            .windows(2)
            .map(|pair| pair[0].lerp(&pair[1], alpha.clone()))
            .collect();
    }
    let n = b.len() - 1;
    let mut left = b.to_vec();
    left[n] = column[0].clone();
    let mut right = b.to_vec();
    right[0] = column[0].clone();
    [left, right]
}
