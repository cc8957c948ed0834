//! Bernstein polynomials and binomial coefficients.

use crate::scalar::Scalar;

/// The binomial coefficient C(n, k) = n!/(k!(n − k)!), and 0 if k < 0 or k > n.
///
/// The value 0 beyond the ends is part of the definition: recursion and derivative of the Bernstein
/// polynomials use it at their ends.
///
/// It is computed in the field `T` itself, by C(n, k) = C(n, k − 1)·(n − k + 1)/k, every partial
/// product of which is a binomial coefficient: exact for exact numbers of any size, and for `f64` as
/// long as k·C(n, k) ≤ 2⁵³.
///
/// # Examples
///
/// ```
/// use cagd::bezier::binomial;
///
/// assert_eq!(binomial::<f64>(4, 2), 6.0);
/// assert_eq!(binomial::<f64>(4, -1), 0.0);
/// assert_eq!(binomial::<f64>(4, 5), 0.0);
/// ```
#[must_use]
pub fn binomial<T: Scalar>(n: usize, k: i64) -> T {
    let n = n as i64;
    if k < 0 || k > n {
        return T::zero();
    }
    (1..=k.min(n - k)).fold(T::one(), |product, j| {
        product * T::from_integer(n - j + 1) / T::from_integer(j)
    })
}

/// The Bernstein polynomial Bᵢⁿ(t) = C(n, i)·tⁱ·(1 − t)ⁿ⁻ⁱ, and 0 if i < 0 or i > n.
///
/// `t` is any number; on [0, 1] the value is in [0, 1].
/// In floating point each value passes at most 3n + 1 roundings.
///
/// # Examples
///
/// ```
/// use cagd::bezier::bernstein;
///
/// assert_eq!(bernstein(2, 1, 0.5), 0.5);
/// assert_eq!(bernstein(2, -1, 0.5), 0.0);
/// assert_eq!(bernstein(0, 0, 7.0), 1.0);
/// ```
///
/// Source: `farin2002`, §5.1.
#[must_use]
pub fn bernstein<T: Scalar>(degree: usize, index: i64, t: T) -> T {
    match usize::try_from(index) {
        Ok(i) if i <= degree => {
            let s = T::one() - t.clone();
            binomial::<T>(degree, index) * num_traits::pow(t, i) * num_traits::pow(s, degree - i)
        }
        _ => T::zero(),
    }
}
