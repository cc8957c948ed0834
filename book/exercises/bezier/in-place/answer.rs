//! The algorithm of de Casteljau in place.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The points b₀ⁿ, b₁ⁿ⁻¹, …, bₙ⁰ of the triangle of de Casteljau at t; `points` are b₀, …, bₙ, at least one.
pub fn evaluate<T: Scalar>(mut points: Vec<Point<T, 2>>, t: T) -> Vec<Point<T, 2>> {
    let n = points.len() - 1;
    //@ solution
    for j in 1..=n {
        for i in 0..=n - j {
            points[i] = points[i].lerp(&points[i + 1], t.clone());
        }
    }
    //@ starter
    //| for _ in 1..=n {
    //|     for i in (0..n).rev() {
    //|         points[i] = points[i].lerp(&points[i + 1], t.clone());
    //|     }
    //| }
    //@ end
    points
}
