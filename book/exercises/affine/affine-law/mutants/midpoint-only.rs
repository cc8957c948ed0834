//! misconception: affine means that midpoints are kept, so the weights need not be looked at

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of the law.
pub fn keeps_affine_combinations(
    f: impl Fn(&BigRational) -> BigRational,
    terms: &[(BigRational, BigRational)],
) -> Sides<BigRational> {
    let zero = || <BigRational as Scalar>::from_integer(0);
    let count = <BigRational as Scalar>::from_integer(terms.len() as i64);
    let mean = terms.iter().fold(zero(), |sum, (_, t)| sum + t) / count.clone();
    let images = terms.iter().fold(zero(), |sum, (_, t)| sum + f(t)) / count;
    Sides::new("").equal(
        "f(mean) = mean of f",
        [f(&mean)],
        [images],
        Rounding::none(),
    )
}
