//! What stands in a cell: a fraction, or a point whose coordinates are fractions.

use std::fmt;

use num_bigint::BigInt;
use num_traits::Zero;

use super::Weights;
use crate::scalar::{BigRational, Scalar};

/// A fraction, or a point whose coordinates are fractions.
///
/// # Examples
///
/// ```
/// use cagd::check::tableau::Entry;
///
/// assert_eq!(Entry::number(6, 8).to_string(), "3/4");
/// assert_eq!(Entry::point([(1, 2), (3, 1)]).to_string(), "(1/2, 3)");
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    coordinates: Vec<BigRational>,
}

impl Entry {
    /// The fraction `numerator / denominator`; the denominator must not be 0.
    #[must_use]
    pub fn number(numerator: i64, denominator: i64) -> Self {
        Self::point([(numerator, denominator)])
    }

    /// The point with these coordinates, each a fraction whose denominator is not 0.
    #[must_use]
    pub fn point(coordinates: impl IntoIterator<Item = (i64, i64)>) -> Self {
        let fraction = |(n, d)| BigRational::from_ratio(n, d);
        Self {
            coordinates: coordinates.into_iter().map(fraction).collect(),
        }
    }

    /// The coordinates; a number has one.
    #[must_use]
    pub fn coordinates(&self) -> &[BigRational] {
        &self.coordinates
    }

    /// How many coordinates there are; 1 for a number.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.coordinates.len()
    }

    /// What the weights make of two entries of the same dimension.
    pub(super) fn combined(weights: &Weights, upper: &Self, lower: &Self) -> Self {
        let pairs = upper.coordinates.iter().zip(&lower.coordinates);
        Self {
            coordinates: pairs
                .map(|(u, l)| &weights.upper * u + &weights.lower * l)
                .collect(),
        }
    }

    /// Reads `3/4`, `-2` or `(1/2, 3)`.
    pub(super) fn parse(text: &str) -> Result<Self, NoEntry> {
        let inside = text
            .strip_prefix('(')
            .and_then(|rest| rest.strip_suffix(')'));
        let coordinates = match inside {
            Some(list) => list.split(',').map(fraction).collect::<Result<_, _>>()?,
            None => vec![fraction(text)?],
        };
        Ok(Self { coordinates })
    }
}

impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.coordinates.as_slice() {
            [number] => number.fmt(f),
            list => {
                let list: Vec<String> = list.iter().map(ToString::to_string).collect();
                write!(f, "({})", list.join(", "))
            }
        }
    }
}

/// Why a text is no entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoEntry {
    NoFraction,
    DivisionByZero,
}

/// Reads `3/4` or `-2`; the long minus sign of the book counts as one.
fn fraction(text: &str) -> Result<BigRational, NoEntry> {
    let whole = |text: &str| {
        let text = text.trim().replace('−', "-");
        text.parse::<BigInt>().map_err(|_| NoEntry::NoFraction)
    };
    let Some((numerator, denominator)) = text.split_once('/') else {
        return Ok(BigRational::from_integer(whole(text)?));
    };
    let (numerator, denominator) = (whole(numerator)?, whole(denominator)?);
    if denominator.is_zero() {
        return Err(NoEntry::DivisionByZero);
    }
    Ok(BigRational::new(numerator, denominator))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_and_points_are_read() {
        for (text, expected) in [
            ("3/4", Entry::number(3, 4)),
            ("-6/8", Entry::number(-3, 4)),
            ("−2", Entry::number(-2, 1)),
            ("+2", Entry::number(2, 1)),
            ("3/-4", Entry::number(-3, 4)),
            ("(1/2, 3)", Entry::point([(1, 2), (3, 1)])),
            ("( 1 / 2,3 )", Entry::point([(1, 2), (3, 1)])),
            ("(0,0,1)", Entry::point([(0, 1), (0, 1), (1, 1)])),
        ] {
            assert_eq!(Entry::parse(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn what_is_no_entry_is_refused() {
        for text in [
            "", "x", "1/2/3", "0.5", "1/", "(1, 2", "1, 2)", "()", "(1,)", "1 2",
        ] {
            assert_eq!(Entry::parse(text), Err(NoEntry::NoFraction), "{text}");
        }
        for text in ["1/0", "0/0", "(1, 2/0)"] {
            assert_eq!(Entry::parse(text), Err(NoEntry::DivisionByZero), "{text}");
        }
    }
}
