//! misconception: only the length of the columns was wrong, the order in which a column is computed does not matter

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The points b₀ⁿ, b₁ⁿ⁻¹, …, bₙ⁰ of the triangle of de Casteljau at t; `points` are b₀, …, bₙ, at least one.
pub fn evaluate<T: Scalar>(mut points: Vec<Point<T, 2>>, t: T) -> Vec<Point<T, 2>> {
    let n = points.len() - 1;
    for j in 1..=n {
        for i in (0..=n - j).rev() {
            points[i] = points[i].lerp(&points[i + 1], t.clone());
        }
    }
    points
}
