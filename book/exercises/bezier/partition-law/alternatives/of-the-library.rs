//! The library's law says the same.

use cagd::law::Sides;
use cagd::scalar::Scalar;

/// Claims that the values of `implementation` for degree n at t are a partition of unity.
pub fn law<T: Scalar>(implementation: impl Fn(usize, T) -> Vec<T>, n: usize, t: T) -> Sides<T> {
    cagd::bezier::laws::partition_of_unity(implementation, n, t)
}
