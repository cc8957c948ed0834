//! misconception: a constant polynomial is no basis, so degree 0 needs no claim

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the values of `implementation` for degree n at t are a partition of unity.
pub fn law<T: Scalar>(implementation: impl Fn(usize, T) -> Vec<T>, n: usize, t: T) -> Sides<T> {
    let sides = Sides::new(format!("n = {n}, t = {t}"));
    if n == 0 {
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
