//! By recursion, as the formula is written; slow, but right.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The point b(t) of the Bézier curve with the control points b₀, …, bₙ, at least one.
pub fn point<T: Scalar>(b: &[Point<T, 2>], t: T) -> Point<T, 2> {
    match b {
        [point] => point.clone(),
        _ => {
            let upper = point(&b[..b.len() - 1], t.clone());
            let lower = point(&b[1..], t.clone());
            upper.lerp(&lower, t)
        }
    }
}
