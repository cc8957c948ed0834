//! misconception: weights of sum 1 are all that a point needs; but the limit also stays the same when the points are refined

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the weights belong to the limit.
pub fn law<T: Scalar>(stencil: impl Fn(&[Vec<T>]) -> Vec<T>, matrix: &[Vec<T>]) -> Sides<T> {
    let weights = stencil(matrix);
    let sides = Sides::new(format!("A = {matrix:?}"));
    let sum = weights.iter().fold(T::zero(), |sum, l| sum + l.clone());
    sides.equal("equal points", [sum], [T::one()], Rounding::none())
}
