//! misconception: for a symmetric stencil it is enough to look at the first point; but each point has an equation of its own

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the weights belong to the limit.
pub fn law<T: Scalar>(stencil: impl Fn(&[Vec<T>]) -> Vec<T>, matrix: &[Vec<T>]) -> Sides<T> {
    let weights = stencil(matrix);
    let sides = Sides::new(format!("A = {matrix:?}"));
    let sum = weights.iter().fold(T::zero(), |sum, l| sum + l.clone());
    let terms = weights.iter().zip(matrix);
    let first = terms.fold(T::zero(), |sum, (l, row)| sum + l.clone() * row[0].clone());
    sides
        .equal("unchanged", [first], [weights[0].clone()], Rounding::none())
        .equal("equal points", [sum], [T::one()], Rounding::none())
}
