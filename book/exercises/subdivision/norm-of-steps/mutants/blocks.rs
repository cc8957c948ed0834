//! misconception: the coefficients of one rule stand next to each other, in blocks; but they are 2^L places apart

use cagd::scalar::{BigRational, OrderedScalar, Scalar};

/// The norm of the steps.
pub fn norm(symbol: &[BigRational], steps: usize) -> BigRational {
    let zero = <BigRational as Scalar>::from_integer(0);
    let length = symbol.len().div_ceil(1 << steps).max(1);
    let sum = |block: &[BigRational]| {
        let sizes = block.iter().map(OrderedScalar::abs);
        sizes.fold(zero.clone(), |sum, c| sum + c)
    };
    symbol
        .chunks(length)
        .map(sum)
        .fold(zero.clone(), OrderedScalar::max)
}
