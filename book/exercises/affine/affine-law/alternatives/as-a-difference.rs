//! The law as an equation with 0.
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of the law.
pub fn keeps_affine_combinations(
    f: impl Fn(&BigRational) -> BigRational,
    terms: &[(BigRational, BigRational)],
) -> Sides<BigRational> {
    let zero = || <BigRational as Scalar>::from_integer(0);
    let mut combination = zero();
    let mut images = zero();
    for (weight, t) in terms {
        combination += weight * t;
        images += weight * f(t);
    }
    let defect = f(&combination) - images;
    Sides::new(format!("{} terms", terms.len())).equal(
        "f(Σλt) − Σλf(t) = 0",
        [defect],
        [zero()],
        Rounding::none(),
    )
}
