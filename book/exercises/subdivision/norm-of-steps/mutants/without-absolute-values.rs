//! misconception: the weights of a rule are summed with their signs; that is 1 for each affine scheme and says nothing about size

use cagd::scalar::{BigRational, OrderedScalar, Scalar};

/// The norm of the steps.
pub fn norm(symbol: &[BigRational], steps: usize) -> BigRational {
    let zero = <BigRational as Scalar>::from_integer(0);
    let rules = 1 << steps;
    let sum = |rule: usize| {
        let members = symbol.iter().skip(rule).step_by(rules);
        let sum = members.fold(zero.clone(), |sum, c| sum + c);
        OrderedScalar::abs(&sum)
    };
    (0..rules).map(sum).fold(zero.clone(), OrderedScalar::max)
}
