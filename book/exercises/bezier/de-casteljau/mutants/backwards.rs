//! misconception: the first of two neighbours has the weight t, so the curve runs from the last control point to the first

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The point b(t) of the Bézier curve with the control points b₀, …, bₙ, at least one.
pub fn point<T: Scalar>(b: &[Point<T, 2>], t: T) -> Point<T, 2> {
    let mut points = b.to_vec();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| pair[1].lerp(&pair[0], t.clone()))
            .collect();
    }
    points.swap_remove(0)
}
