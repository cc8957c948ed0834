//! misconception: the law for two terms implies the one for many, so it is enough to compare the first two

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of the law.
pub fn keeps_affine_combinations(
    f: impl Fn(&BigRational) -> BigRational,
    terms: &[(BigRational, BigRational)],
) -> Sides<BigRational> {
    let zero = || <BigRational as Scalar>::from_integer(0);
    let one = <BigRational as Scalar>::from_integer(1);
    let (Some((_, s)), Some((weight, t))) = (terms.first(), terms.get(1)) else {
        return Sides::new("").equal("f = f", [f(&zero())], [f(&zero())], Rounding::none());
    };
    let rest = one - weight;
    let left = f(&(&rest * s + weight * t));
    let right = rest * f(s) + weight * f(t);
    Sides::new("").equal("f(Σλt) = Σλf(t)", [left], [right], Rounding::none())
}
