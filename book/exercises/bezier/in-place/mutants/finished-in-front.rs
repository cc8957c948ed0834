//! misconception: column j begins at entry j - 1, as the finished entries stand in front

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The points b₀ⁿ, b₁ⁿ⁻¹, …, bₙ⁰ of the triangle of de Casteljau at t; `points` are b₀, …, bₙ, at least one.
pub fn evaluate<T: Scalar>(mut points: Vec<Point<T, 2>>, t: T) -> Vec<Point<T, 2>> {
    let n = points.len() - 1;
    for j in 1..=n {
        for i in j - 1..n {
            points[i] = points[i].lerp(&points[i + 1], t.clone());
        }
    }
    points
}
