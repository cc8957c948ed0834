//! misconception: both sides may be computed as the sum of the weighted images, since the law says they are equal

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of the law.
pub fn keeps_affine_combinations(
    f: impl Fn(&BigRational) -> BigRational,
    terms: &[(BigRational, BigRational)],
) -> Sides<BigRational> {
    let zero = || <BigRational as Scalar>::from_integer(0);
    let left = terms
        .iter()
        .fold(zero(), |sum, (weight, t)| sum + weight * f(t));
    let right = terms
        .iter()
        .fold(zero(), |sum, (weight, t)| sum + f(t) * weight);
    Sides::new("").equal("both sides", [left], [right], Rounding::none())
}
