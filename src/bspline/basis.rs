//! The uniform B-spline: the basis function over the knots 0, 1, …, n + 1.

use crate::scalar::OrderedScalar;

/// The value Nⁿ(u) of the uniform B-spline of degree n with the knots 0, 1, …, n + 1.
///
/// ```text
/// N⁰(u) = 1 for 0 ≤ u < 1, else 0,
/// Nⁿ(u) = (u·Nⁿ⁻¹(u) + (n + 1 − u)·Nⁿ⁻¹(u − 1))/n
/// ```
///
/// It is positive on (0, n + 1), zero elsewhere, and its integer shifts sum to 1.
/// The values are computed by the recurrence, all shifts that are needed at once, in n(n + 1)/2 steps.
///
/// # Examples
///
/// ```
/// use cagd::bspline::uniform_b_spline;
/// use cagd::scalar::{BigRational, Scalar};
///
/// let ratio = <BigRational as Scalar>::from_ratio;
/// assert_eq!(uniform_b_spline(2, ratio(3, 2)), ratio(3, 4));
/// assert_eq!([1, 2, 3].map(|k| uniform_b_spline(3, ratio(k, 1))), [ratio(1, 6), ratio(4, 6), ratio(1, 6)]);
/// assert_eq!(uniform_b_spline(0, 1.0), 0.0, "the piece [0, 1) of degree 0 is open at its end");
/// ```
///
/// Source: `prautzsch2002`, §5.2.
#[must_use]
pub fn uniform_b_spline<T: OrderedScalar>(degree: usize, u: T) -> T {
    // values[l] = Nʳ(u − l)
    let shifted = |l: usize| u.clone() - T::from_integer(l as i64);
    let mut values: Vec<T> = (0..=degree)
        .map(|l| {
            let x = shifted(l);
            if T::zero() <= x && x < T::one() {
                T::one()
            } else {
                T::zero()
            }
        })
        .collect();
    for r in 1..=degree {
        for l in 0..=degree - r {
            let x = shifted(l);
            let rest = T::from_integer(r as i64 + 1) - x.clone();
            let sum = x * values[l].clone() + rest * values[l + 1].clone();
            values[l] = sum / T::from_integer(r as i64);
        }
    }
    values.swap_remove(0)
}
