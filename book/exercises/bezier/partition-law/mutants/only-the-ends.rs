//! misconception: it is enough to look at both ends, where one value is 1 and the others are 0

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the values of `implementation` for degree n at t are a partition of unity.
pub fn law<T: Scalar>(implementation: impl Fn(usize, T) -> Vec<T>, n: usize, t: T) -> Sides<T> {
    let sides = Sides::new(format!("n = {n}, t = {t}"));
    let _ = t;
    let ends = [T::zero(), T::one()].map(|t| implementation(n, t));
    let sum = |values: &Vec<T>| values.iter().cloned().fold(T::zero(), |sum, v| sum + v);
    sides
        .equal(
            "there are n + 1 values",
            ends.iter()
                .map(|values| T::from_integer(values.len() as i64)),
            [(); 2].map(|()| T::from_integer(n as i64 + 1)),
            Rounding::none(),
        )
        .equal(
            "they sum to 1",
            ends.iter().map(sum),
            [T::one(), T::one()],
            Rounding::none(),
        )
}
