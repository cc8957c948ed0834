//! misconception: if the sum is the same at t and at 1 - t, it is the same everywhere

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the values of `implementation` for degree n at t are a partition of unity.
pub fn law<T: Scalar>(implementation: impl Fn(usize, T) -> Vec<T>, n: usize, t: T) -> Sides<T> {
    let sides = Sides::new(format!("n = {n}, t = {t}"));
    let values = implementation(n, t.clone());
    let mirrored = implementation(n, T::one() - t);
    let sum = |values: &[T]| values.iter().cloned().fold(T::zero(), |sum, v| sum + v);
    sides
        .equal(
            "there are n + 1 values",
            [T::from_integer(values.len() as i64)],
            [T::from_integer(n as i64 + 1)],
            Rounding::none(),
        )
        .equal(
            "they sum to 1",
            [sum(&values)],
            [sum(&mirrored)],
            Rounding::none(),
        )
}
