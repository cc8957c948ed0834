//! Cosines of parts of a full turn, in floating point and, where they are rational, exactly.
//!
//! The weights of a scheme at a vertex of valence k hold cos(2πj/k).
//! This number is rational only if the reduced fraction j/k has the denominator 1, 2, 3, 4 or 6
//! (Niven's theorem), so rational arithmetic serves the valences 3, 4 and 6.

use thiserror::Error;

use crate::scalar::{BigRational, Complex64, Dual64, Scalar};

/// Numbers that know the cosines of parts of a full turn.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::{CosineError, CosineOfTurn};
///
/// assert_eq!(f64::cosine_of_turn(1, 3)?, -0.5, "rational values are exact in floating point too");
/// assert!((f64::cosine_of_turn(1, 5)? - 0.309_016_994_374_947_4).abs() < 1e-15);
/// assert_eq!(BigRational::cosine_of_turn(-1, 6)?, BigRational::from_ratio(1, 2));
///
/// let refused = BigRational::cosine_of_turn(2, 5).unwrap_err();
/// assert_eq!(refused, CosineError::Irrational { numerator: 2, denominator: 5 });
/// # Ok::<(), CosineError>(())
/// ```
pub trait CosineOfTurn: Scalar {
    /// cos(2π · `numerator` / `denominator`).
    ///
    /// Rational values are exact for every type; others differ from the true ones by at most 12·2⁻⁵³.
    ///
    /// # Errors
    ///
    /// [`CosineError::NoDenominator`] if `denominator` is 0,
    /// [`CosineError::Irrational`] if the type has rational numbers only and the value is none.
    fn cosine_of_turn(numerator: i64, denominator: usize) -> Result<Self, CosineError>;
}

/// Why there is no such cosine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CosineError {
    /// A turn divided into no parts.
    ///
    /// ```
    /// use cagd::subdivision::{CosineError, CosineOfTurn};
    /// assert_eq!(f64::cosine_of_turn(1, 0), Err(CosineError::NoDenominator { numerator: 1 }));
    /// ```
    #[error(
        "the cosine of {numerator}/0 of a turn needs a denominator of at least 1, found 0; give the number of parts"
    )]
    NoDenominator {
        /// How many parts.
        numerator: i64,
    },
    /// A rational number was asked for, and the cosine is irrational.
    ///
    /// ```
    /// use cagd::scalar::BigRational;
    /// use cagd::subdivision::CosineOfTurn;
    /// let refused = BigRational::cosine_of_turn(1, 5).unwrap_err();
    /// assert!(refused.to_string().contains("valence 3, 4 or 6"));
    /// ```
    #[error(
        "the cosine of {numerator}/{denominator} of a turn must be rational to be exact, but it is irrational; \
         take valence 3, 4 or 6, or compute in f64"
    )]
    Irrational {
        /// How many parts.
        numerator: i64,
        /// Parts of what number of equal ones.
        denominator: usize,
    },
}

/// The part of a turn in [0, 1/2] with the same cosine, as numerator and denominator.
fn folded(numerator: i64, denominator: usize) -> Result<(i128, i128), CosineError> {
    if denominator == 0 {
        return Err(CosineError::NoDenominator { numerator });
    }
    let parts = denominator as i128;
    let part = i128::from(numerator).rem_euclid(parts);
    Ok((part.min(parts - part), parts))
}

/// Twice the cosine of a part of a turn in [0, 1/2], where that is rational.
fn twice_the_cosine((part, parts): (i128, i128)) -> Option<i64> {
    let is = |p: i128, q: i128| part * q == p * parts;
    [(0, 1, 2), (1, 6, 1), (1, 4, 0), (1, 3, -1), (1, 2, -2)]
        .into_iter()
        .find_map(|(p, q, twice)| is(p, q).then_some(twice))
}

impl CosineOfTurn for f64 {
    // The angle is at most π and passes three roundings, which move its cosine by at most 3π·2⁻⁵³;
    // libm's cosine is off by less than one unit in the last place, 2·2⁻⁵³ of a number up to 1.
    fn cosine_of_turn(numerator: i64, denominator: usize) -> Result<Self, CosineError> {
        let turn = folded(numerator, denominator)?;
        Ok(match twice_the_cosine(turn) {
            Some(twice) => twice as f64 / 2.0,
            None => libm::cos(std::f64::consts::TAU * turn.0 as f64 / turn.1 as f64),
        })
    }
}

impl CosineOfTurn for BigRational {
    fn cosine_of_turn(numerator: i64, denominator: usize) -> Result<Self, CosineError> {
        twice_the_cosine(folded(numerator, denominator)?)
            .map(|twice| BigRational::from_ratio(twice, 2))
            .ok_or(CosineError::Irrational {
                numerator,
                denominator,
            })
    }
}

impl CosineOfTurn for Dual64 {
    fn cosine_of_turn(numerator: i64, denominator: usize) -> Result<Self, CosineError> {
        f64::cosine_of_turn(numerator, denominator).map(Dual64::from_re)
    }
}

impl CosineOfTurn for Complex64 {
    fn cosine_of_turn(numerator: i64, denominator: usize) -> Result<Self, CosineError> {
        f64::cosine_of_turn(numerator, denominator).map(Complex64::from)
    }
}
