//! The three-direction box spline M₂₂₂, the limit of Loop's scheme on regular meshes.

use crate::scalar::OrderedScalar;

/// The value M₂₂₂(x) of the three-direction box spline, with its centre at the origin.
///
/// M₁₁₀ is 1 on the unit square [0, 1)² and 0 elsewhere; each further direction e, one of (1, 0), (0, 1), (1, 1),
/// averages along it,
///
/// ```text
/// M'(x) = ∫₀¹ M(x − t·e) dt,
/// ```
///
/// until each direction has been used twice.
/// The mean over [0, 1] is the integral over the whole half line minus the same one step further.
/// So with the truncated power
///
/// ```text
/// T(u, v) = ∫₀^w s(u − s)(v − s) ds = uv·w²/2 − (u + v)·w³/3 + w⁴/4,   w = min(u, v),
/// ```
///
/// for u, v > 0, and T = 0 elsewhere, the box spline is the sum of
/// (−1)^(i+j+k) C(2,i) C(2,j) C(2,k) T(x₁ + 2 − i − k, x₂ + 2 − j − k) over i, j, k = 0, 1, 2.
///
/// In floating point the terms cancel: on the support all products of the sum together are below 2300 in absolute value.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::box_spline_222;
///
/// let integer = |n| <BigRational as Scalar>::from_integer(n);
/// let at = |x, y| box_spline_222(&[integer(x), integer(y)]);
/// assert_eq!(at(0, 0), BigRational::from_ratio(1, 2));
/// assert_eq!(at(1, 1), BigRational::from_ratio(1, 12));
/// assert_eq!(at(1, -1), integer(0), "this is not an edge of the lattice");
/// ```
///
/// Source: `deboor1993`.
#[must_use]
pub fn box_spline_222<T: OrderedScalar>(x: &[T; 2]) -> T {
    const BINOMIAL: [i64; 3] = [1, -2, 1];
    let mut sum = T::zero();
    for (i, along_x) in BINOMIAL.into_iter().enumerate() {
        for (j, along_y) in BINOMIAL.into_iter().enumerate() {
            for (k, along_diagonal) in BINOMIAL.into_iter().enumerate() {
                let shift = |own: usize| T::from_integer(2 - own as i64 - k as i64);
                let term = truncated_power(x[0].clone() + shift(i), x[1].clone() + shift(j));
                if !term.is_zero() {
                    sum += T::from_integer(along_x * along_y * along_diagonal) * term;
                }
            }
        }
    }
    sum
}

/// T(u, v), the integral of s(u − s)(v − s) from 0 to min(u, v).
fn truncated_power<T: OrderedScalar>(u: T, v: T) -> T {
    if u <= T::zero() || v <= T::zero() {
        return T::zero();
    }
    let w = OrderedScalar::min(u.clone(), v.clone());
    let square = w.clone() * w.clone();
    let product = u.clone() * v.clone();
    let inner = product * T::from_ratio(1, 2) - (u + v) * w.clone() * T::from_ratio(1, 3)
        + square.clone() * T::from_ratio(1, 4);
    square * inner
}
