//! Derivatives of Bernstein polynomials.

use super::bernstein::{bernstein, binomial};
use crate::affine::Interval;
use crate::scalar::Scalar;

/// The derivative of the Bernstein polynomial Bᵢⁿ at t.
///
/// ```text
/// d/dt Bᵢⁿ(t) = n·(Bᵢ₋₁ⁿ⁻¹(t) − Bᵢⁿ⁻¹(t))
/// ```
///
/// `index` is any whole number, also where Bᵢⁿ = 0; `t` is any number. For n = 0 the derivative is 0.
///
/// # Examples
///
/// ```
/// use cagd::bezier::bernstein_derivative;
///
/// // B₁² = 2t(1 − t) has the derivative 2 − 4t.
/// assert_eq!(bernstein_derivative(2, 1, 0.25), 1.0);
/// // B₀² = (1 − t)² has the derivative −2(1 − t): the neighbour on the left is 0.
/// assert_eq!(bernstein_derivative(2, 0, 0.25), -1.5);
/// ```
///
/// Source: `farin2002`, §5.3.
#[must_use]
pub fn bernstein_derivative<T: Scalar>(degree: usize, index: i64, t: T) -> T {
    match degree.checked_sub(1) {
        None => T::zero(),
        Some(lower) => {
            T::from_integer(degree as i64)
                * (bernstein(lower, index - 1, t.clone()) - bernstein(lower, index, t))
        }
    }
}

/// The p-th derivative of the Bernstein polynomial Bᵢᵐ over [a, b] at u, p = `order` ≥ 0.
///
/// ```text
/// dᵖ/duᵖ Bᵢᵐ(u; [a, b]) = m!/(m − p)!/(b − a)ᵖ · Σⱼ (−1)ᵖ⁻ʲ·C(p, j)·Bᵢ₋ⱼᵐ⁻ᵖ(u; [a, b]),   j = 0 … p
/// ```
///
/// It is 0 for p > m.
///
/// # Examples
///
/// ```
/// use cagd::affine::Interval;
/// use cagd::bezier::bernstein_higher_derivative;
///
/// // B₂² over [0, 4] is (u/4)²; its second derivative is 2/16.
/// let interval = Interval::new(0.0, 4.0)?;
/// assert_eq!(bernstein_higher_derivative(&interval, 2, 2, 2, 1.0), 0.125);
/// # Ok::<(), cagd::affine::IntervalError>(())
/// ```
///
/// Source: `prautzsch2002`, §2.4.
#[must_use]
pub fn bernstein_higher_derivative<T: Scalar>(
    domain: &Interval<T>,
    degree: usize,
    index: i64,
    order: usize,
    u: T,
) -> T {
    let Some(lower) = degree.checked_sub(order) else {
        return T::zero();
    };
    let t = domain.local(u);
    let factor = (lower + 1..=degree).fold(T::one(), |product, k| {
        product * (T::from_integer(k as i64) / domain.length())
    });
    let sum = (0..=order as i64).fold(T::zero(), |sum, j| {
        let term = binomial::<T>(order, j) * bernstein(lower, index - j, t.clone());
        if (order as i64 - j) % 2 == 0 {
            sum + term
        } else {
            sum - term
        }
    });
    factor * sum
}
