//! The refinement equation of the uniform B-splines, as a law.

use cagd::bezier::binomial;
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Claims that `b_spline(degree, u)` is the value of the uniform B-spline with the knots 0, …, `degree` + 1.
///
/// `u` lies between 0 and `degree` + 1.
pub fn law(
    b_spline: impl Fn(usize, BigRational) -> BigRational,
    degree: usize,
    u: &BigRational,
) -> Sides<BigRational> {
    let number = |n: i64| <BigRational as Scalar>::from_integer(n);
    let last = degree as i64 + 1;
    let sides = Sides::new(format!("n = {degree}, u = {u}"));
    //@ solution
    let copies = (0..=last).fold(number(0), |sum, j| {
        let weight: BigRational = binomial(degree + 1, j);
        sum + weight * b_spline(degree, number(2) * u - number(j))
    });
    let shifts = (-last..=last).fold(number(0), |sum, j| sum + b_spline(degree, u - number(j)));
    sides
        .equal(
            "the copies half as wide",
            [b_spline(degree, u.clone())],
            [copies / number(1 << degree)],
            Rounding::none(),
        )
        .equal("the shifts", [shifts], [number(1)], Rounding::none())
    //@ starter
    //| // Only the first and the last copy so far: right for degree 0.
    //| let copy = |j: i64| {
    //|     let weight: BigRational = binomial(degree + 1, j);
    //|     weight * b_spline(degree, number(2) * u - number(j))
    //| };
    //| let copies = (copy(0) + copy(last)) / number(1 << degree);
    //| let value = b_spline(degree, u.clone());
    //| sides.equal("the copies half as wide", [value], [copies], Rounding::none())
    //@ end
}
