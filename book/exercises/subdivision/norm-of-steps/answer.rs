//! The norm of several steps of a scheme.

use cagd::scalar::{BigRational, OrderedScalar, Scalar};

/// The largest sum of absolute values over the coefficients of one of the 2^`steps` rules.
///
/// `symbol` holds the coefficients of the symbol of as many steps, beginning with that of z⁰.
pub fn norm(symbol: &[BigRational], steps: usize) -> BigRational {
    let zero = <BigRational as Scalar>::from_integer(0);
    //@ solution
    let rules = 1 << steps;
    let sum = |rule: usize| {
        let members = symbol.iter().skip(rule).step_by(rules);
        members.fold(zero.clone(), |sum, c| sum + OrderedScalar::abs(c))
    };
    (0..rules).map(sum).fold(zero.clone(), OrderedScalar::max)
    //@ starter
    //| // Right if every rule has one coefficient only.
    //| let _ = steps;
    //| symbol.iter().map(OrderedScalar::abs).fold(zero, OrderedScalar::max)
    //@ end
}
