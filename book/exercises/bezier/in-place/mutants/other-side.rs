//! misconception: the new point may as well be written over the lower one of the two

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The points b₀ⁿ, b₁ⁿ⁻¹, …, bₙ⁰ of the triangle of de Casteljau at t; `points` are b₀, …, bₙ, at least one.
pub fn evaluate<T: Scalar>(mut points: Vec<Point<T, 2>>, t: T) -> Vec<Point<T, 2>> {
    let n = points.len() - 1;
    for j in 1..=n {
        for i in (j..=n).rev() {
            points[i] = points[i - 1].lerp(&points[i], t.clone());
        }
    }
    points.reverse();
    points
}
