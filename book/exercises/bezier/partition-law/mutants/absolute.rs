//! misconception: weights that sum to one are between 0 and 1, so their absolute values sum to one

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the values of `implementation` for degree n at t are a partition of unity.
pub fn law<T: Scalar>(implementation: impl Fn(usize, T) -> Vec<T>, n: usize, t: T) -> Sides<T> {
    let sides = Sides::new(format!("n = {n}, t = {t}"));
    let values = implementation(n, t);
    let total: f64 = values.iter().map(T::magnitude).sum();
    sides
        .equal(
            "there are n + 1 values",
            [T::from_integer(values.len() as i64)],
            [T::from_integer(n as i64 + 1)],
            Rounding::none(),
        )
        .equal(
            "they sum to 1",
            [T::from_integer((total * 1024.0).round() as i64)],
            [T::from_integer(1024)],
            Rounding::none(),
        )
}
