//! misconception: degree n has the binomials of n; but n + 2 copies are needed, with those of n + 1

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
    let value = b_spline(degree, u.clone());
    let shifts = (-last..=last).fold(number(0), |sum, j| sum + b_spline(degree, u - number(j)));
    let copies = |row: usize, sign: i64| {
        (0..=row as i64).fold(number(0), |sum, j| {
            let weight: BigRational = binomial(row, j);
            sum + weight * b_spline(degree, number(2) * u - number(sign * j))
        })
    };
    let exact = Rounding::none;
    let copies = copies(degree, 1) / number(1 << degree);
    sides.equal("copies", [value], [copies], exact()).equal(
        "shifts",
        [shifts],
        [number(1)],
        exact(),
    )
}
