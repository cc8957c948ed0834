//! misconception: the sum is all that counts, whatever number of values has it

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that the values of `implementation` for degree n at t are a partition of unity.
pub fn law<T: Scalar>(implementation: impl Fn(usize, T) -> Vec<T>, n: usize, t: T) -> Sides<T> {
    let sides = Sides::new(format!("n = {n}, t = {t}"));
    let values = implementation(n, t);
    sides.equal(
        "they sum to 1",
        [values.into_iter().fold(T::zero(), |sum, value| sum + value)],
        [T::one()],
        Rounding::none(),
    )
}
