//! With a window that shrinks.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The points b₀ⁿ, b₁ⁿ⁻¹, …, bₙ⁰ of the triangle of de Casteljau at t; `points` are b₀, …, bₙ, at least one.
pub fn evaluate<T: Scalar>(mut points: Vec<Point<T, 2>>, t: T) -> Vec<Point<T, 2>> {
    let n = points.len() - 1;
    for last in (0..n).rev() {
        let mut i = 0;
        while i <= last {
            points[i] = points[i].lerp(&points[i + 1], t.clone());
            i += 1;
        }
    }
    points
}
