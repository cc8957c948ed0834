//! The number types that the algorithms of this crate run over.
//!
//! ```text
//! Scalar            a field: + − · ÷, no order, no tolerance     Complex64, Dual64, f64, BigRational
//!   └ OrderedScalar  adds <, for hulls and inequalities                              f64, BigRational
//!       └ Real       adds roots and trigonometry                                     f64
//! ```
//!
//! One algorithm, written once over [`Scalar`], gives floating-point values, exact values,
//! derivatives (dual numbers) and complex values.

use std::fmt::Display;

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign};
use num_traits::{One, Zero};

pub use num_complex::Complex64;
pub use num_dual::Dual64;
pub use num_rational::BigRational;

/// Half the distance from 1 to the next `f64`: the largest relative error of one rounding, 2⁻⁵³.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// An element of a field: the numbers that affine geometry needs, and nothing more.
///
/// There is no order and no tolerance here.
/// Two exact numbers are compared by `==`; who compares rounded numbers must give a bound
/// (see [`law`](crate::law)).
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
///
/// fn mean<T: Scalar>(a: T, b: T) -> T {
///     (a + b) * T::from_ratio(1, 2)
/// }
///
/// assert_eq!(mean(1.0, 2.0), 1.5);
/// assert_eq!(mean(BigRational::from_ratio(1, 1), BigRational::from_ratio(2, 1)), BigRational::from_ratio(3, 2));
/// ```
pub trait Scalar:
    nalgebra::Scalar
    + Display
    + Zero
    + One
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
    + std::ops::Neg<Output = Self>
    + Send
    + Sync
{
    /// Whether arithmetic is exact, so that equality of numbers is `==`.
    const EXACT: bool;

    /// The number `n`.
    ///
    /// Not exact for floating-point types if |n| > 2⁵³.
    fn from_integer(n: i64) -> Self;

    /// The fraction `numerator / denominator`; `denominator` must not be 0.
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Self::from_integer(numerator) / Self::from_integer(denominator)
    }

    /// The absolute value as an `f64`, for bounds and for display; of a dual number that of its value.
    fn magnitude(&self) -> f64;

    /// Whether the number is neither infinite nor NaN. Exact numbers always are.
    fn is_finite(&self) -> bool;
}

/// A scalar with an order, for inequalities, convex hulls and boxes.
pub trait OrderedScalar: Scalar + PartialOrd {
    /// The nearest `f64` (infinite if the number is beyond its range).
    fn to_f64(&self) -> f64;

    /// The absolute value.
    fn abs(&self) -> Self {
        if *self < Self::zero() {
            -self.clone()
        } else {
            self.clone()
        }
    }

    /// The smaller of two numbers; the first if they cannot be compared.
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// The larger of two numbers; the first if they cannot be compared.
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

/// An ordered scalar with roots and trigonometry.
///
/// They come from the `libm` crate and not from the platform, so that a figure has the same bytes
/// on every machine and in the browser.
pub trait Real: OrderedScalar + Copy {
    /// The number nearest to `x`.
    fn from_f64(x: f64) -> Self;
    /// The square root; NaN for negative numbers.
    fn sqrt(self) -> Self;
    /// The sine of an angle in radians.
    fn sin(self) -> Self;
    /// The cosine of an angle in radians.
    fn cos(self) -> Self;
    /// The angle in (−π, π] of the vector (`x`, `self`).
    fn atan2(self, x: Self) -> Self;
    /// `self` to the power `exponent`.
    fn powf(self, exponent: Self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
}

impl Scalar for f64 {
    const EXACT: bool = false;

    fn from_integer(n: i64) -> Self {
        n as f64
    }

    fn magnitude(&self) -> f64 {
        f64::abs(*self)
    }

    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }
}

impl OrderedScalar for f64 {
    fn to_f64(&self) -> f64 {
        *self
    }
}

impl Real for f64 {
    fn from_f64(x: f64) -> Self {
        x
    }

    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }

    fn sin(self) -> Self {
        libm::sin(self)
    }

    fn cos(self) -> Self {
        libm::cos(self)
    }

    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }

    fn powf(self, exponent: Self) -> Self {
        libm::pow(self, exponent)
    }

    fn ln(self) -> Self {
        libm::log(self)
    }
}

impl Scalar for BigRational {
    const EXACT: bool = true;

    fn from_integer(n: i64) -> Self {
        BigRational::from_integer(n.into())
    }

    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        BigRational::new(numerator.into(), denominator.into())
    }

    fn magnitude(&self) -> f64 {
        f64::abs(OrderedScalar::to_f64(self))
    }

    fn is_finite(&self) -> bool {
        true
    }
}

impl OrderedScalar for BigRational {
    fn to_f64(&self) -> f64 {
        num_traits::ToPrimitive::to_f64(self).unwrap_or(f64::NAN)
    }
}

impl Scalar for Dual64 {
    const EXACT: bool = false;

    fn from_integer(n: i64) -> Self {
        Dual64::from_re(n as f64)
    }

    fn magnitude(&self) -> f64 {
        f64::abs(self.re)
    }

    fn is_finite(&self) -> bool {
        self.re.is_finite() && self.eps.is_finite()
    }
}

impl Scalar for Complex64 {
    const EXACT: bool = false;

    fn from_integer(n: i64) -> Self {
        Complex64::new(n as f64, 0.0)
    }

    fn magnitude(&self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    fn is_finite(&self) -> bool {
        Complex64::is_finite(*self)
    }
}

/// The exact number that an `f64` stands for.
///
/// Every finite `f64` is a fraction with a power of two below.
/// `None` for NaN and infinities.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar, exact};
///
/// assert_eq!(exact(0.375), Some(BigRational::from_ratio(3, 8)));
/// assert_ne!(exact(0.1), Some(BigRational::from_ratio(1, 10)), "0.1 is not a binary fraction");
/// assert_eq!(exact(f64::NAN), None);
/// ```
#[must_use]
pub fn exact(x: f64) -> Option<BigRational> {
    BigRational::from_float(x)
}
