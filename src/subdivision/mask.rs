//! Binary schemes given by a mask: one rule for the points of even index, one for those of odd index.

use std::fmt;
use std::ops::Range;

use thiserror::Error;

use super::laurent::LaurentPolynomial;
use crate::affine::{Affine, Linear, sums_to};
use crate::scalar::Scalar;

/// The mask a = (aᵢ) of a binary subdivision scheme for curves.
///
/// ```text
/// (S p)ᵢ = Σⱼ aᵢ₋₂ⱼ · pⱼ
/// ```
///
/// The coefficients of even index are the rule for the new points of even index, those of odd index
/// the rule for the others.
/// The Laurent polynomial a(z) = Σ aᵢzⁱ is the [`symbol`](Mask::symbol) of the scheme.
///
/// Source: `dyn-levin2002`, §2.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::Mask;
///
/// let chaikin = Mask::new(0, [0.25, 0.75, 0.75, 0.25])?;
/// assert_eq!(chaikin, Mask::lane_riesenfeld(2));
/// let triangle = [0.0, 4.0, 8.0];
/// assert_eq!(chaikin.refine_closed(&triangle)?, [6.0, 2.0, 1.0, 3.0, 5.0, 7.0]);
/// # Ok::<(), cagd::subdivision::MaskError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mask<T> {
    symbol: LaurentPolynomial<T>,
}

/// The indices of a mask lie between the negative of this and this.
const FARTHEST_OF_A_MASK: i64 = 1 << 31;

/// The indices of points lie between the negative of this and this, so that they can be doubled.
const FARTHEST_OF_POINTS: i64 = 1 << 61;

fn check_indices(first: i64, count: usize, farthest: i64) -> Result<(), MaskError> {
    let behind = i64::try_from(count).ok().and_then(|n| first.checked_add(n));
    if first >= -farthest && behind.is_some_and(|behind| behind <= farthest) {
        return Ok(());
    }
    Err(MaskError::Index {
        first,
        count,
        farthest,
    })
}

impl<T: Scalar> Mask<T> {
    /// The mask whose coefficients, beginning with that of index `first`, are given.
    ///
    /// # Errors
    ///
    /// [`MaskError::Zero`] if every coefficient is 0 or there is none,
    /// [`MaskError::NotFinite`] if one is infinite or NaN, [`MaskError::Index`] if an index lies beyond ±2³¹.
    ///
    /// ```
    /// use cagd::subdivision::{Mask, MaskError};
    ///
    /// let refused = Mask::new(i64::MAX, [0.5, 1.0, 0.5]).unwrap_err();
    /// assert!(matches!(refused, MaskError::Index { .. }));
    /// ```
    pub fn new(first: i64, coefficients: impl IntoIterator<Item = T>) -> Result<Self, MaskError> {
        let coefficients: Vec<T> = coefficients.into_iter().collect();
        check_indices(first, coefficients.len(), FARTHEST_OF_A_MASK)?;
        Self::from_symbol(LaurentPolynomial::new(first, coefficients))
    }

    /// The mask with this symbol.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn from_symbol(symbol: LaurentPolynomial<T>) -> Result<Self, MaskError> {
        if symbol.is_zero() {
            return Err(MaskError::Zero);
        }
        let length = symbol.coefficients().len();
        check_indices(symbol.powers().start, length, FARTHEST_OF_A_MASK)?;
        if let Some((index, c)) = symbol.terms().find(|(_, c)| !c.is_finite()) {
            return Err(MaskError::NotFinite {
                index,
                found: c.to_string(),
            });
        }
        Ok(Self { symbol })
    }

    /// The scheme of Lane and Riesenfeld of degree n: (1 + z)ⁿ⁺¹/2ⁿ.
    ///
    /// Degree 1 inserts midpoints, degree 2 is Chaikin's corner cutting, degree 0 duplicates every point.
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// let cubic: Mask<f64> = Mask::lane_riesenfeld(3);
    /// assert_eq!(cubic.symbol().coefficients(), [0.125, 0.5, 0.75, 0.5, 0.125]);
    /// ```
    #[must_use]
    pub fn lane_riesenfeld(degree: usize) -> Self {
        let half = T::from_ratio(1, 2);
        let scale = (0..degree).fold(T::one(), |power, _| power * half.clone());
        Self {
            symbol: LaurentPolynomial::one_plus_z_to(degree + 1).scaled(&scale),
        }
    }

    /// The four-point scheme with tension parameter w; w = 1/16 is the one that keeps cubics.
    ///
    /// ```text
    /// z⁻³·(−w + (1/2 + w)z² + z³ + (1/2 + w)z⁴ − w·z⁶)
    /// ```
    ///
    /// # Errors
    ///
    /// [`MaskError::NotFinite`] if w is infinite or NaN.
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// let mask = Mask::four_point(0.0625)?;
    /// assert_eq!(mask.support(), -3..4);
    /// assert_eq!(mask.symbol().coefficients(), [-0.0625, 0.0, 0.5625, 1.0, 0.5625, 0.0, -0.0625]);
    /// assert!(Mask::four_point(f64::NAN).is_err());
    /// # Ok::<(), cagd::subdivision::MaskError>(())
    /// ```
    pub fn four_point(tension: T) -> Result<Self, MaskError> {
        let outer = -tension.clone();
        let inner = T::from_ratio(1, 2) + tension;
        let zero = T::zero();
        Self::new(
            -3,
            [
                outer.clone(),
                zero.clone(),
                inner.clone(),
                T::one(),
                inner,
                zero,
                outer,
            ],
        )
    }

    /// The symbol a(z).
    #[must_use]
    pub fn symbol(&self) -> &LaurentPolynomial<T> {
        &self.symbol
    }

    /// The coefficient aᵢ.
    #[must_use]
    pub fn coefficient(&self, i: i64) -> T {
        self.symbol.coefficient(i)
    }

    /// The indices from the first nonzero coefficient to the last.
    #[must_use]
    pub fn support(&self) -> Range<i64> {
        self.symbol.powers()
    }

    /// The rule for the new point of index `i`: the old indices j with their weights aᵢ₋₂ⱼ.
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// let chaikin = Mask::lane_riesenfeld(2);
    /// assert_eq!(chaikin.rule(4), [(1, 0.75), (2, 0.25)]);
    /// assert_eq!(chaikin.rule(5), [(1, 0.25), (2, 0.75)]);
    /// ```
    #[must_use]
    pub fn rule(&self, i: i64) -> Vec<(i64, T)> {
        // In larger numbers, for an index near the end of its range.
        let Range { start, end } = self.support();
        let [i, start, end] = [i, start, end].map(i128::from);
        // i − 2j runs from the last index of the support down to the first.
        let lowest = (i - end + 1).div_euclid(2) + (i - end + 1).rem_euclid(2);
        let highest = (i - start).div_euclid(2);
        (lowest..=highest)
            .map(|j| (j as i64, self.coefficient((i - 2 * j) as i64)))
            .collect()
    }

    /// Whether the weights of each rule sum to 1, so that the scheme is one of points.
    #[must_use]
    pub fn is_affine(&self) -> bool {
        [0, 1].into_iter().all(|parity| {
            let rule = self.rule(parity);
            sums_to(rule.iter().map(|(_, weight)| weight), T::one())
        })
    }

    /// One step for a sequence of numbers with finitely many nonzero members.
    ///
    /// Every new number is computed by its rule.
    ///
    /// ```
    /// use cagd::subdivision::{LaurentPolynomial, Mask};
    ///
    /// let mask: Mask<f64> = Mask::lane_riesenfeld(2);
    /// let one = LaurentPolynomial::one();
    /// assert_eq!(mask.apply(&one), *mask.symbol());
    /// ```
    #[must_use]
    pub fn apply(&self, data: &LaurentPolynomial<T>) -> LaurentPolynomial<T> {
        let (support, powers) = (self.support(), data.powers());
        if powers.is_empty() {
            return LaurentPolynomial::zero();
        }
        let first = 2 * powers.start + support.start;
        let last = 2 * (powers.end - 1) + support.end - 1;
        let refined = (first..=last).map(|i| {
            let terms = self.rule(i).into_iter();
            terms.fold(T::zero(), |sum, (j, weight)| {
                sum + weight * data.coefficient(j)
            })
        });
        LaurentPolynomial::new(first, refined)
    }

    /// The symbol of `count` steps in one: a(z)·a(z²)·a(z⁴)⋯, 1 for no step.
    ///
    /// It has about 2^count times as many coefficients as the mask.
    ///
    /// ```
    /// use cagd::subdivision::Mask;
    ///
    /// let midpoints: Mask<f64> = Mask::lane_riesenfeld(1);
    /// assert_eq!(midpoints.steps(2).coefficients(), [0.25, 0.5, 0.75, 1.0, 0.75, 0.5, 0.25]);
    /// ```
    #[must_use]
    pub fn steps(&self, count: usize) -> LaurentPolynomial<T> {
        (0..count).fold(LaurentPolynomial::one(), |data, _| self.apply(&data))
    }

    /// One step for a closed polygon p₀, …, pₙ₋₁, indices modulo n: 2n points, beginning with index 0.
    ///
    /// # Errors
    ///
    /// [`MaskError::NotAffine`] if a rule is no affine combination, [`MaskError::TooFew`] if there is no point.
    pub fn refine_closed<P: Affine<Scalar = T>>(&self, points: &[P]) -> Result<Vec<P>, MaskError> {
        self.check_affine()?;
        if points.is_empty() {
            return Err(MaskError::TooFew {
                needed: 1,
                found: 0,
            });
        }
        let count = points.len() as i64;
        let cyclic = |j: i64| &points[j.rem_euclid(count) as usize];
        Ok((0..2 * count).map(|i| self.combine(i, cyclic)).collect())
    }

    /// One step for points pⱼ, j = `first`, `first` + 1, …, of which no more are known.
    ///
    /// The answer holds the new points that can be computed, and the index of the first of them.
    ///
    /// # Errors
    ///
    /// [`MaskError::NotAffine`] if a rule is no affine combination,
    /// [`MaskError::TooFew`] if no new point can be computed, [`MaskError::Index`] if an index lies beyond ±2⁶¹.
    ///
    /// ```
    /// use cagd::subdivision::{Mask, MaskError};
    ///
    /// let cubic = Mask::lane_riesenfeld(3);
    /// let (first, refined) = cubic.refine_window(0, &[0.0, 8.0, 0.0])?;
    /// assert_eq!((first, refined), (3, vec![4.0, 6.0, 4.0]));
    /// assert_eq!(cubic.refine_window(0, &[8.0]), Err(MaskError::TooFew { needed: 2, found: 1 }));
    /// # Ok::<(), MaskError>(())
    /// ```
    pub fn refine_window<P: Affine<Scalar = T>>(
        &self,
        first: i64,
        points: &[P],
    ) -> Result<(i64, Vec<P>), MaskError> {
        self.check_affine()?;
        self.over_window(first, points)
    }

    /// As [`refine_window`](Self::refine_window) for vectors or numbers, whose weights may have any sum.
    ///
    /// # Errors
    ///
    /// [`MaskError::TooFew`] if no new vector can be computed, [`MaskError::Index`] if an index lies beyond ±2⁶¹.
    pub fn apply_window<V: Linear<Scalar = T>>(
        &self,
        first: i64,
        vectors: &[V],
    ) -> Result<(i64, Vec<V>), MaskError> {
        self.over_window(first, vectors)
    }

    /// The indices of the new points that can be computed from the old ones of the indices `known`.
    ///
    /// An index beyond the range of its type counts as the end of this range.
    #[must_use]
    pub fn computable(&self, known: Range<i64>) -> Range<i64> {
        let support = self.support();
        let twice = |index: i64, shift: i64| index.saturating_mul(2).saturating_add(shift);
        twice(known.start, support.end - 2)..twice(known.end, support.start)
    }

    fn over_window<P: Affine<Scalar = T>>(
        &self,
        first: i64,
        points: &[P],
    ) -> Result<(i64, Vec<P>), MaskError> {
        check_indices(first, points.len(), FARTHEST_OF_POINTS)?;
        let new = self.computable(first..first + points.len() as i64);
        if new.is_empty() {
            let width = self.support().end - self.support().start;
            return Err(MaskError::TooFew {
                needed: (width / 2) as usize,
                found: points.len(),
            });
        }
        let known = |j: i64| &points[(j - first) as usize];
        let refined = new.clone().map(|i| self.combine(i, known)).collect();
        Ok((new.start, refined))
    }

    /// The new point of index `i`.
    fn combine<'a, P: Affine<Scalar = T>>(&self, i: i64, point: impl Fn(i64) -> &'a P) -> P {
        let rule = self.rule(i);
        P::from_fn(|k| {
            rule.iter().fold(T::zero(), |sum, (j, weight)| {
                sum + weight.clone() * point(*j).coordinates()[k].clone()
            })
        })
    }

    fn check_affine(&self) -> Result<(), MaskError> {
        if self.is_affine() {
            return Ok(());
        }
        let sum = |parity: i64| {
            let rule = self.rule(parity).into_iter();
            rule.fold(T::zero(), |sum, (_, weight)| sum + weight)
                .to_string()
        };
        Err(MaskError::NotAffine {
            even: sum(0),
            odd: sum(1),
        })
    }
}

impl<T: Scalar> fmt::Display for Mask<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "mask {}", self.symbol)
    }
}

/// Why a mask cannot be made or used.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MaskError {
    /// There is no coefficient but 0.
    #[error("a mask needs a coefficient that is not 0; give the weights of both rules")]
    Zero,
    /// A coefficient is NaN or infinite.
    #[error(
        "coefficient {index} of the mask is {found}; every coefficient must be a finite number"
    )]
    NotFinite {
        /// Its index.
        index: i64,
        /// The coefficient.
        found: String,
    },
    /// An index is too far from 0.
    #[error(
        "{count} indices from {first} on do not lie between −{farthest} and {farthest}; shift them towards 0"
    )]
    Index {
        /// The first index.
        first: i64,
        /// How many there are.
        count: usize,
        /// The largest index that can be used.
        farthest: i64,
    },
    /// The weights of a rule do not sum to 1, so that it makes no point of points.
    #[error(
        "the weights of both rules must sum to 1 to refine points, not to {even} (even) and {odd} (odd); refine vectors by `apply_window`"
    )]
    NotAffine {
        /// Sum of the even rule.
        even: String,
        /// Sum of the odd rule.
        odd: String,
    },
    /// There are not enough points for any new one.
    #[error(
        "one step of this scheme needs {needed} points or more, found {found}; add points at the ends"
    )]
    TooFew {
        /// The smallest number of points.
        needed: usize,
        /// How many there are.
        found: usize,
    },
}
