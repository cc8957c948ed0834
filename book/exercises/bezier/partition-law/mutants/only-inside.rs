//! misconception: outside of [0, 1] the polynomials are not used, so nothing needs to be claimed there

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the values of `implementation` for degree n at t are a partition of unity.
pub fn law<T: Scalar>(implementation: impl Fn(usize, T) -> Vec<T>, n: usize, t: T) -> Sides<T> {
    let sides = Sides::new(format!("n = {n}, t = {t}"));
    let is_inside = t.magnitude() <= 1.0 && (T::one() - t.clone()).magnitude() <= 1.0;
    if !is_inside {
        return sides.equal("nothing", [t.clone()], [t], Rounding::none());
    }
    let values = implementation(n, t);
    sides
        .equal(
            "there are n + 1 values",
            [T::from_integer(values.len() as i64)],
            [T::from_integer(n as i64 + 1)],
            Rounding::none(),
        )
        .equal(
            "they sum to 1",
            [values.into_iter().fold(T::zero(), |sum, value| sum + value)],
            [T::one()],
            Rounding::none(),
        )
}
