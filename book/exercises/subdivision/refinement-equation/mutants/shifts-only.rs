//! misconception: what sums to 1 with its shifts is a B-spline of this degree; but all B-splines do so

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Claims that `b_spline(degree, u)` is the value of the uniform B-spline.
pub fn law(
    b_spline: impl Fn(usize, BigRational) -> BigRational,
    degree: usize,
    u: &BigRational,
) -> Sides<BigRational> {
    let number = |n: i64| <BigRational as Scalar>::from_integer(n);
    let last = degree as i64 + 1;
    let sides = Sides::new(format!("n = {degree}, u = {u}"));
    let shifts = (-last..=last).fold(number(0), |sum, j| sum + b_spline(degree, u - number(j)));
    sides.equal("shifts", [shifts], [number(1)], Rounding::none())
}
