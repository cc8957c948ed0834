//! misconception: weights are between 0 and 1, so nothing is claimed if one is negative

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of the law.
pub fn keeps_affine_combinations(
    f: impl Fn(&BigRational) -> BigRational,
    terms: &[(BigRational, BigRational)],
) -> Sides<BigRational> {
    let zero = || <BigRational as Scalar>::from_integer(0);
    let is_convex = terms.iter().all(|(weight, _)| *weight >= zero());
    let combination = terms
        .iter()
        .fold(zero(), |sum, (weight, t)| sum + weight * t);
    let images = terms
        .iter()
        .fold(zero(), |sum, (weight, t)| sum + weight * f(t));
    let left = if is_convex {
        f(&combination)
    } else {
        images.clone()
    };
    Sides::new("").equal("f(Σλt) = Σλf(t)", [left], [images], Rounding::none())
}
