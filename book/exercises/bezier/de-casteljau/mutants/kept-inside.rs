//! misconception: outside of [0, 1] the curve stays at its end points

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The point b(t) of the Bézier curve with the control points b₀, …, bₙ, at least one.
pub fn point<T: Scalar>(b: &[Point<T, 2>], t: T) -> Point<T, 2> {
    let size = |x: &T| x.magnitude();
    let s = T::one() - t.clone();
    if size(&t) + size(&s) > 1.0 {
        let end = if size(&t) > size(&s) { b.len() - 1 } else { 0 };
        return b[end].clone();
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
