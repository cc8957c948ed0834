//! misconception: a map of the line is affine if it keeps sums, as a linear one does

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of the law.
pub fn keeps_affine_combinations(
    f: impl Fn(&BigRational) -> BigRational,
    terms: &[(BigRational, BigRational)],
) -> Sides<BigRational> {
    let zero = || <BigRational as Scalar>::from_integer(0);
    let total = terms.iter().fold(zero(), |sum, (_, t)| sum + t);
    let images = terms.iter().fold(zero(), |sum, (_, t)| sum + f(t));
    Sides::new("").equal("f(Σt) = Σf(t)", [f(&total)], [images], Rounding::none())
}
