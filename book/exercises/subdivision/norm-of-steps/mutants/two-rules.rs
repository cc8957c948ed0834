//! misconception: a scheme has two rules, also after several steps; but L steps together have 2^L

use cagd::scalar::{BigRational, OrderedScalar, Scalar};

/// The norm of the steps.
pub fn norm(symbol: &[BigRational], steps: usize) -> BigRational {
    let zero = <BigRational as Scalar>::from_integer(0);
    let rules = if steps == 0 { 1 } else { 2 };
    let sum = |rule: usize| {
        let members = symbol.iter().skip(rule).step_by(rules);
        members.fold(zero.clone(), |sum, c| sum + OrderedScalar::abs(c))
    };
    (0..rules).map(sum).fold(zero.clone(), OrderedScalar::max)
}
