//! Bernstein polynomials and binomial coefficients.

use num_traits::pow;
use thiserror::Error;

use crate::affine::Interval;
use crate::scalar::Scalar;

/// The factorial n! = n·(n − 1)⋯1, with 0! = 1.
///
/// For `f64` it is exact up to 22!, and infinite from 171! on.
///
/// # Examples
///
/// ```
/// use cagd::bezier::factorial;
///
/// assert_eq!(factorial::<f64>(0), 1.0);
/// assert_eq!(factorial::<f64>(5), 120.0);
/// assert_eq!(factorial::<f64>(171), f64::INFINITY);
/// ```
#[must_use]
pub fn factorial<T: Scalar>(n: usize) -> T {
    (1..=n as i64).fold(T::one(), |product, j| product * T::from_integer(j))
}

/// The binomial coefficient C(n, k) = n!/(k!(n − k)!), and 0 if k < 0 or k > n.
///
/// The value 0 beyond the ends is part of the definition: recursion and derivative of the Bernstein
/// polynomials use it at their ends.
///
/// It is computed in the field `T` itself, by C(n, k) = C(n, k − 1)·(n − k + 1)/k, every partial
/// product of which is a binomial coefficient: exact for exact numbers of any size, and for `f64` as
/// long as k·C(n, k) ≤ 2⁵³.
/// For `f64` and n ≤ 1020 it is finite; above, the coefficients in the middle of the row may be infinite.
/// [`bernstein`] does not need them.
///
/// # Examples
///
/// ```
/// use cagd::bezier::binomial;
///
/// assert_eq!(binomial::<f64>(4, 2), 6.0);
/// assert_eq!(binomial::<f64>(4, -1), 0.0);
/// assert_eq!(binomial::<f64>(4, 5), 0.0);
/// assert!((0..=1020).all(|k| binomial::<f64>(1020, k).is_finite()));
/// assert_eq!(binomial::<f64>(2000, 1000), f64::INFINITY);
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
/// It is right for every degree, also where C(n, i) overflows and tⁱ underflows: the factors are
/// multiplied in an order that keeps the product near 1.
///
/// # Examples
///
/// ```
/// use cagd::bezier::bernstein;
///
/// assert_eq!(bernstein(2, 1, 0.5), 0.5);
/// assert_eq!(bernstein(2, -1, 0.5), 0.0);
/// assert_eq!(bernstein(0, 0, 7.0), 1.0);
///
/// // C(10000, 5000) is about 10³⁰⁰⁸. Stirling's formula gives √(2/(πn)) for the value in the middle.
/// let middle = bernstein(10_000, 5_000, 0.5);
/// assert!((middle - (2.0 / (std::f64::consts::PI * 1e4)).sqrt()).abs() < 1e-4 * middle);
/// ```
///
/// Source: `farin2002`, §5.1.
#[must_use]
pub fn bernstein<T: Scalar>(degree: usize, index: i64, t: T) -> T {
    match usize::try_from(index) {
        Ok(i) if i <= degree => {
            let s = T::one() - t.clone();
            if T::EXACT {
                binomial::<T>(degree, index) * pow(t, i) * pow(s, degree - i)
            } else if 2 * i <= degree {
                balanced_product(degree, i, t, s)
            } else {
                balanced_product(degree, degree - i, s, t)
            }
        }
        _ => T::zero(),
    }
}

/// C(n, i)·tⁱ·sⁿ⁻ⁱ for 2i ≤ n.
///
/// A factor s is taken whenever the product exceeds 1, and one of the i factors (n − i + j)/j·t otherwise.
/// For t in [0, 1] this neither overflows nor underflows before its time:
/// once all factors s are used, the product is Bⱼⁿ⁻ⁱ⁺ʲ(t), at most 1; and as the other factors
/// decrease with j, a product below 1 grows until they are below 1, and then only falls to the result.
fn balanced_product<T: Scalar>(degree: usize, i: usize, t: T, s: T) -> T {
    let mut product = T::one();
    let mut rest = degree - i;
    for j in 1..=i {
        while rest > 0 && product.magnitude() > 1.0 {
            product *= s.clone();
            rest -= 1;
        }
        product *= T::from_integer((degree - i + j) as i64);
        product /= T::from_integer(j as i64);
        product *= t.clone();
    }
    for _ in 0..rest {
        product *= s.clone();
    }
    product
}

/// All values B₀ⁿ(t), …, Bₙⁿ(t), by the recursion.
///
/// ```text
/// B₀⁰ = 1,   Bᵢʲ = (1 − t)·Bᵢʲ⁻¹ + t·Bᵢ₋₁ʲ⁻¹
/// ```
///
/// n(n + 1) products and as many sums at most, in one array, without a binomial coefficient.
/// On [0, 1] nothing is subtracted: every value has a relative error of at most γ₃ₙ (and underflow).
///
/// # Examples
///
/// ```
/// use cagd::bezier::bernstein_basis;
///
/// assert_eq!(bernstein_basis(3, 0.5), [0.125, 0.375, 0.375, 0.125]);
/// assert_eq!(bernstein_basis(0, 0.3), [1.0]);
/// ```
///
/// Source: `piegl1997`, §1.3.
#[must_use]
pub fn bernstein_basis<T: Scalar>(degree: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let mut values = Vec::with_capacity(degree + 1);
    values.push(T::one());
    for j in 1..=degree {
        values.push(T::zero());
        for i in (1..=j).rev() {
            values[i] = s.clone() * values[i].clone() + t.clone() * values[i - 1].clone();
        }
        values[0] *= s.clone();
    }
    values
}

/// The Bernstein polynomial over an interval, Bᵢⁿ(u; [a, b]) = C(n, i)·(u − a)ⁱ·(b − u)ⁿ⁻ⁱ/(b − a)ⁿ.
///
/// It is Bᵢⁿ(t) at the local parameter t = (u − a)/(b − a).
///
/// # Examples
///
/// ```
/// use cagd::affine::Interval;
/// use cagd::bezier::{bernstein, bernstein_on};
///
/// let interval = Interval::new(2.0, 6.0)?;
/// assert_eq!(bernstein_on(3, 1, &interval, 3.0), bernstein(3, 1, 0.25));
/// # Ok::<(), cagd::affine::IntervalError>(())
/// ```
#[must_use]
pub fn bernstein_on<T: Scalar>(degree: usize, index: i64, interval: &Interval<T>, u: T) -> T {
    bernstein(degree, index, interval.local(u))
}

/// Where a Bernstein polynomial has its maximum on its interval, and how large it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BernsteinMaximum<T> {
    /// The place a + (b − a)·i/n.
    pub place: T,
    /// The value C(n, i)·(i/n)ⁱ·((n − i)/n)ⁿ⁻ⁱ, with 0⁰ = 1.
    pub value: T,
}

/// The one maximum of Bᵢⁿ on `interval`.
///
/// # Errors
///
/// [`BernsteinError::NoMaximum`] for degree 0, where the polynomial is constant, and for an index above the degree.
///
/// # Examples
///
/// ```
/// use cagd::affine::Interval;
/// use cagd::bezier::{BernsteinError, bernstein_maximum};
/// use cagd::scalar::{BigRational, Scalar};
///
/// let maximum = bernstein_maximum::<BigRational>(3, 1, &Interval::unit())?;
/// assert_eq!(maximum.place, BigRational::from_ratio(1, 3));
/// assert_eq!(maximum.value, BigRational::from_ratio(4, 9));
/// assert_eq!(bernstein_maximum::<f64>(0, 0, &Interval::unit()), Err(BernsteinError::NoMaximum { degree: 0, index: 0 }));
/// # Ok::<(), BernsteinError>(())
/// ```
///
/// Source: `farin2002`, §5.1.
pub fn bernstein_maximum<T: Scalar>(
    degree: usize,
    index: usize,
    interval: &Interval<T>,
) -> Result<BernsteinMaximum<T>, BernsteinError> {
    if degree == 0 || index > degree {
        return Err(BernsteinError::NoMaximum { degree, index });
    }
    let place = T::from_ratio(index as i64, degree as i64);
    Ok(BernsteinMaximum {
        place: interval.global(place.clone()),
        value: bernstein(degree, index as i64, place),
    })
}

/// Why a Bernstein polynomial lacks what was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum BernsteinError {
    /// The polynomial is constant.
    #[error(
        "the Bernstein polynomial of degree {degree} and index {index} has no single maximum; give a degree of at least 1 and an index from 0 to the degree"
    )]
    NoMaximum {
        /// The degree.
        degree: usize,
        /// The index.
        index: usize,
    },
}
