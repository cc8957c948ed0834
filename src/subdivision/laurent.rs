//! Polynomials with negative powers too: the algebra of subdivision.

use std::fmt;
use std::ops::{Add, Mul, Range, Sub};

use crate::scalar::{OrderedScalar, Scalar};

/// A Laurent polynomial Σ cᵢ·zⁱ, i from some whole number to another, negative ones too.
///
/// A sequence of numbers with finitely many nonzero members is written as one; so convolution is multiplication,
/// and a shift of the indices is multiplication by a power of z.
/// The zeros at both ends are not kept, so that equal polynomials are `==`.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::LaurentPolynomial;
///
/// // z⁻¹·(1 + z)²/2
/// let hat = LaurentPolynomial::new(-1, [0.5, 1.0, 0.5]);
/// assert_eq!(hat.powers(), -1..2);
/// assert_eq!(hat.coefficient(0), 1.0);
/// assert_eq!(hat.coefficient(7), 0.0);
/// assert_eq!((hat.at(1.0), hat.at(-1.0)), (Some(2.0), Some(0.0)));
/// assert_eq!(&hat * &LaurentPolynomial::new(1, [2.0]), LaurentPolynomial::new(0, [1.0, 2.0, 1.0]));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LaurentPolynomial<T> {
    lowest: i64,
    coefficients: Vec<T>,
}

/// The lowest power lies between the negative of this and this, so that sums and doubles of powers are still numbers.
const FARTHEST: i64 = 1 << 60;

impl<T: Scalar> LaurentPolynomial<T> {
    /// The polynomial whose coefficients, beginning with that of `z^lowest`, are given.
    ///
    /// # Arguments
    ///
    /// `lowest`: between −2⁶⁰ and 2⁶⁰; a power beyond counts as the nearest of these, here and in every product and shift.
    #[must_use]
    pub fn new(lowest: i64, coefficients: impl IntoIterator<Item = T>) -> Self {
        let mut coefficients: Vec<T> = coefficients.into_iter().collect();
        while coefficients.last().is_some_and(T::is_zero) {
            coefficients.pop();
        }
        let zeros = coefficients.iter().take_while(|c| c.is_zero()).count();
        coefficients.drain(..zeros);
        if coefficients.is_empty() {
            return Self::zero();
        }
        Self {
            lowest: lowest
                .saturating_add(zeros as i64)
                .clamp(-FARTHEST, FARTHEST),
            coefficients,
        }
    }

    /// The polynomial 0.
    #[must_use]
    pub fn zero() -> Self {
        Self {
            lowest: 0,
            coefficients: Vec::new(),
        }
    }

    /// The polynomial 1: the sequence that is 1 at the index 0 and 0 elsewhere.
    #[must_use]
    pub fn one() -> Self {
        Self::new(0, [T::one()])
    }

    /// The polynomial (1 + z)ⁿ.
    #[must_use]
    pub fn one_plus_z_to(n: usize) -> Self {
        let factor = Self::new(0, [T::one(), T::one()]);
        (0..n).fold(Self::one(), |power, _| &power * &factor)
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// From the lowest power with a nonzero coefficient up to the highest; empty for 0.
    #[must_use]
    pub fn powers(&self) -> Range<i64> {
        self.lowest..self.lowest + self.coefficients.len() as i64
    }

    /// The coefficients, that of the lowest power first; the first and the last are not 0.
    #[must_use]
    pub fn coefficients(&self) -> &[T] {
        &self.coefficients
    }

    /// The coefficient of zⁱ, which is 0 outside of [`powers`](Self::powers).
    #[must_use]
    pub fn coefficient(&self, i: i64) -> T {
        i.checked_sub(self.lowest)
            .and_then(|k| usize::try_from(k).ok())
            .and_then(|k| self.coefficients.get(k))
            .cloned()
            .unwrap_or_else(T::zero)
    }

    /// The powers with their coefficients, zeros in between included.
    pub fn terms(&self) -> impl Iterator<Item = (i64, &T)> {
        self.powers().zip(&self.coefficients)
    }

    /// The value at `z`; `None` at 0 if there are negative powers.
    #[must_use]
    pub fn at(&self, z: T) -> Option<T> {
        if z.is_zero() && self.lowest < 0 {
            return None;
        }
        let horner = |sum: T, c: &T| sum * z.clone() + c.clone();
        let value = self.coefficients.iter().rev().fold(T::zero(), horner);
        let power = power(z, self.lowest.unsigned_abs());
        Some(if self.lowest < 0 {
            value / power
        } else {
            value * power
        })
    }

    /// The polynomial in `z^factor`: the members of the sequence move apart, with zeros between them.
    #[must_use]
    pub fn stretched(&self, factor: usize) -> Self {
        let factor = factor.max(1);
        let last = self.coefficients.len().saturating_sub(1);
        let spread = self.coefficients.iter().enumerate().flat_map(|(k, c)| {
            let zeros = if k < last { factor - 1 } else { 0 };
            std::iter::once(c.clone()).chain(std::iter::repeat_n(T::zero(), zeros))
        });
        let factor = i64::try_from(factor).unwrap_or(i64::MAX);
        Self::new(self.lowest.saturating_mul(factor), spread)
    }

    /// The polynomial times `z^by`: all indices grow by that number.
    #[must_use]
    pub fn shifted(&self, by: i64) -> Self {
        Self::new(
            self.lowest.saturating_add(by),
            self.coefficients.iter().cloned(),
        )
    }

    /// The polynomial times a number.
    #[must_use]
    pub fn scaled(&self, factor: &T) -> Self {
        let scaled = self.coefficients.iter().map(|c| c.clone() * factor.clone());
        Self::new(self.lowest, scaled)
    }

    /// The quotient by `1 + slope·z`; `None` if a remainder is left.
    ///
    /// The remainder is compared with 0 and not with a tolerance, so take exact numbers where it matters.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::LaurentPolynomial;
    ///
    /// let chaikin = LaurentPolynomial::new(0, [0.25, 0.75, 0.75, 0.25]);
    /// assert_eq!(chaikin.divided_by_one_plus(1.0), Some(LaurentPolynomial::new(0, [0.25, 0.5, 0.25])));
    /// assert_eq!(chaikin.divided_by_one_plus(-1.0), None, "it is not 0 at z = 1");
    /// ```
    #[must_use]
    pub fn divided_by_one_plus(&self, slope: T) -> Option<Self> {
        let mut carried = T::zero();
        let quotient: Vec<T> = self
            .coefficients
            .iter()
            .map(|c| {
                carried = c.clone() - slope.clone() * carried.clone();
                carried.clone()
            })
            .collect();
        carried.is_zero().then(|| Self::new(self.lowest, quotient))
    }

    fn combined(&self, other: &Self, combine: impl Fn(T, T) -> T) -> Self {
        if self.is_zero() && other.is_zero() {
            return Self::zero();
        }
        // 0 has the empty range, which must not stretch that of the other.
        let [a, b] = match (self.is_zero(), other.is_zero()) {
            (true, _) => [other.powers(), other.powers()],
            (_, true) => [self.powers(), self.powers()],
            _ => [self.powers(), other.powers()],
        };
        let (low, high) = (a.start.min(b.start), a.end.max(b.end));
        let sum = (low..high).map(|i| combine(self.coefficient(i), other.coefficient(i)));
        Self::new(low, sum)
    }
}

impl<T: OrderedScalar> LaurentPolynomial<T> {
    /// The largest sum of absolute values over the coefficients whose powers agree modulo `rules`.
    ///
    /// For a symbol of L steps and 2^L rules it is the norm of these steps: how large a new number can become
    /// if no old one is larger than 1.
    ///
    /// ```
    /// use cagd::subdivision::LaurentPolynomial;
    ///
    /// let p = LaurentPolynomial::new(0, [1.0, -2.0, 3.0, 0.5]);
    /// assert_eq!(p.norm(1), 6.5);
    /// assert_eq!(p.norm(2), 4.0, "the even powers; 2.5 for the odd ones");
    /// ```
    #[must_use]
    pub fn norm(&self, rules: usize) -> T {
        let rules = rules.max(1);
        let sum = |first: usize| {
            let members = self.coefficients.iter().skip(first).step_by(rules);
            members.fold(T::zero(), |sum, c| sum + c.abs())
        };
        let used = rules.min(self.coefficients.len());
        (0..used).map(sum).fold(T::zero(), OrderedScalar::max)
    }
}

/// `base` to an exponent of 64 bits on every platform, which that of `num_traits::pow` is not, by repeated squaring.
fn power<T: Scalar>(mut base: T, mut exponent: u64) -> T {
    let mut power = T::one();
    while exponent > 0 {
        if exponent % 2 == 1 {
            power *= base.clone();
        }
        exponent /= 2;
        // The last square is not needed, and would be the largest number of all.
        if exponent > 0 {
            base = base.clone() * base;
        }
    }
    power
}

impl<T: Scalar> Mul for &LaurentPolynomial<T> {
    type Output = LaurentPolynomial<T>;

    fn mul(self, other: Self) -> LaurentPolynomial<T> {
        if self.is_zero() || other.is_zero() {
            return LaurentPolynomial::zero();
        }
        let length = self.coefficients.len() + other.coefficients.len() - 1;
        let mut product = vec![T::zero(); length];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j] += a.clone() * b.clone();
            }
        }
        LaurentPolynomial::new(self.lowest + other.lowest, product)
    }
}

impl<T: Scalar> Add for &LaurentPolynomial<T> {
    type Output = LaurentPolynomial<T>;

    fn add(self, other: Self) -> LaurentPolynomial<T> {
        self.combined(other, |a, b| a + b)
    }
}

impl<T: Scalar> Sub for &LaurentPolynomial<T> {
    type Output = LaurentPolynomial<T>;

    fn sub(self, other: Self) -> LaurentPolynomial<T> {
        self.combined(other, |a, b| a - b)
    }
}

/// Writes the terms, the lowest power first, such as `(1/2) z^-1 + (1) z^0 + (1/2) z^1`.
impl<T: Scalar> fmt::Display for LaurentPolynomial<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let terms: Vec<String> = self
            .terms()
            .filter(|(_, c)| !c.is_zero())
            .map(|(i, c)| format!("({c}) z^{i}"))
            .collect();
        if terms.is_empty() {
            f.write_str("0")
        } else {
            f.write_str(&terms.join(" + "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_is_neutral_and_annihilates() {
        let zero = LaurentPolynomial::<f64>::zero();
        let far = LaurentPolynomial::new(5, [1.0, 2.0]);
        assert_eq!(&zero + &far, far);
        assert_eq!(&far - &far, zero);
        assert_eq!(&far * &zero, zero);
        assert_eq!(&zero - &far, far.scaled(&-1.0));
        assert_eq!(zero.stretched(2), zero);
        assert_eq!(zero.powers(), 0..0);
        assert_eq!(
            LaurentPolynomial::new(-3, [0.0, 0.0, 4.0, 0.0]).powers(),
            -1..0
        );
    }

    #[test]
    fn values_at_negative_powers() {
        let p = LaurentPolynomial::new(-2, [3.0, 0.0, 1.0]);
        assert_eq!(p.at(2.0), Some(0.75 + 1.0));
        assert_eq!(p.at(0.0), None);
        assert_eq!(p.shifted(2).at(0.0), Some(3.0));
        assert_eq!(p.stretched(3).at(2.0), p.at(8.0));
    }

    #[test]
    fn values_at_powers_too_high_to_multiply_one_by_one() {
        let far = LaurentPolynomial::new(1 << 60, [3.0, 1.0]);
        assert_eq!(far.at(1.0), Some(4.0));
        assert_eq!(far.at(-1.0), Some(2.0), "the lower power is even");
        assert_eq!(far.shifted(-(1 << 60) + 13).at(2.0), Some(5.0 * 8192.0));
    }
}
