//! misconception: an eigenvector may have any length; but equal points stay where they are only if the weights sum to 1

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the weights belong to the limit.
pub fn law<T: Scalar>(stencil: impl Fn(&[Vec<T>]) -> Vec<T>, matrix: &[Vec<T>]) -> Sides<T> {
    let weights = stencil(matrix);
    let sides = Sides::new(format!("A = {matrix:?}"));
    let column = |j: usize| {
        let terms = weights.iter().zip(matrix);
        terms.fold(T::zero(), |sum, (l, row)| sum + l.clone() * row[j].clone())
    };
    let refined: Vec<T> = (0..matrix.len()).map(column).collect();
    sides.equal("unchanged", refined, weights, Rounding::none())
}
