//! The definition of a limit stencil as a law.

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that `stencil(matrix)` are the weights of the limit.
pub fn law<T: Scalar>(stencil: impl Fn(&[Vec<T>]) -> Vec<T>, matrix: &[Vec<T>]) -> Sides<T> {
    let weights = stencil(matrix);
    let sides = Sides::new(format!("A = {matrix:?}"));
    //@ solution
    let column = |j: usize| {
        let terms = weights.iter().zip(matrix);
        terms.fold(T::zero(), |sum, (l, row)| sum + l.clone() * row[j].clone())
    };
    let sum = weights.iter().fold(T::zero(), |sum, l| sum + l.clone());
    let refined: Vec<T> = (0..matrix.len()).map(column).collect();
    sides
        .equal(
            "refined points have the same limit",
            refined,
            weights,
            Rounding::none(),
        )
        .equal("equal points", [sum], [T::one()], Rounding::none())
    //@ starter
    //| // Only the number of the weights so far.
    //| let [found, expected] = [weights.len(), matrix.len()].map(|n| T::from_integer(n as i64));
    //| sides.equal("one weight a point", [found], [expected], Rounding::none())
    //@ end
}
