//! misconception: A·l = l is the condition, as rows and columns are the same for a symmetric rule; but A itself need not be symmetric, and the condition is l·A = l

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the weights belong to the limit.
pub fn law<T: Scalar>(stencil: impl Fn(&[Vec<T>]) -> Vec<T>, matrix: &[Vec<T>]) -> Sides<T> {
    let weights = stencil(matrix);
    let sides = Sides::new(format!("A = {matrix:?}"));
    let sum = weights.iter().fold(T::zero(), |sum, l| sum + l.clone());
    let row = |row: &Vec<T>| {
        let terms = weights.iter().zip(row);
        terms.fold(T::zero(), |sum, (l, a)| sum + l.clone() * a.clone())
    };
    let refined: Vec<T> = matrix.iter().map(row).collect();
    sides
        .equal("unchanged", refined, weights, Rounding::none())
        .equal("equal points", [sum], [T::one()], Rounding::none())
}
