//! misconception: it is enough that one of the rules contracts, so the smallest sum counts; but the points of the other rules have to come closer, too

use cagd::scalar::{BigRational, OrderedScalar, Scalar};

/// The norm of the steps.
pub fn norm(symbol: &[BigRational], steps: usize) -> BigRational {
    let zero = <BigRational as Scalar>::from_integer(0);
    let rules = 1 << steps;
    let sum = |rule: usize| {
        let members = symbol.iter().skip(rule).step_by(rules);
        members.fold(zero.clone(), |sum, c| sum + OrderedScalar::abs(c))
    };
    (0..rules)
        .map(sum)
        .reduce(OrderedScalar::min)
        .unwrap_or(zero.clone())
}
