//! misconception: all weights together sum to 1; but they sum to 2, since the copies are half as wide

use cagd::bezier::binomial;
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
    let copies = (0..=last).fold(number(0), |sum, j| {
        let weight: BigRational = binomial(degree + 1, j);
        sum + weight * b_spline(degree, number(2) * u - number(j))
    });
    sides
        .equal(
            "copies",
            [b_spline(degree, u.clone())],
            [copies / number(1 << (degree + 1))],
            Rounding::none(),
        )
        .equal("shifts", [shifts], [number(1)], Rounding::none())
}
