//! The law of affine maps of the line.

use cagd::law::{Rounding, Sides};
use cagd::scalar::BigRational;

/// Both sides of f(Σ λᵢtᵢ) = Σ λᵢf(tᵢ) for the terms (λᵢ, tᵢ), whose weights sum to 1.
pub fn keeps_affine_combinations(
    f: impl Fn(&BigRational) -> BigRational,
    terms: &[(BigRational, BigRational)],
) -> Sides<BigRational> {
    //@ solution
    let zero = BigRational::default;
    let combination = terms
        .iter()
        .fold(zero(), |sum, (weight, t)| sum + weight * t);
    let images = terms
        .iter()
        .fold(zero(), |sum, (weight, t)| sum + weight * f(t));
    let input: Vec<String> = terms
        .iter()
        .map(|(weight, t)| format!("({weight}, {t})"))
        .collect();
    Sides::new(input.join(", ")).equal(
        "f(Σλt) = Σλf(t)",
        [f(&combination)],
        [images],
        Rounding::none(),
    )
    //@ starter
    //| // This is the law of the identity, and only for one parameter.
    //| let t = &terms[0].1;
    //| Sides::new("").equal("f(t) = t", [f(t)], [t.clone()], Rounding::none())
    //@ end
}
