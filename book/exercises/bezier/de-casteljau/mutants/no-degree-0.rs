//! misconception: a single control point makes no curve, so the origin will do

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The point b(t) of the Bézier curve with the control points b₀, …, bₙ, at least one.
pub fn point<T: Scalar>(b: &[Point<T, 2>], t: T) -> Point<T, 2> {
    if b.len() < 2 {
        return Point::origin();
    }
    let mut points = b.to_vec();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| pair[0].lerp(&pair[1], t.clone()))
            .collect();
    }
    points.swap_remove(0)
}
