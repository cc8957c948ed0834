//! A law beside a figure: both sides, in numbers that a reader can take in.

use crate::law::Reading;
use crate::scalar::Scalar;

/// How many significant digits a side is shown with.
const DIGITS: usize = 4;

/// One claim of a law, for the values that a figure is drawn with.
#[derive(Debug, Clone, PartialEq)]
pub struct LawReading {
    /// What is claimed.
    pub claim: String,
    /// The left side, rounded for display.
    pub left: String,
    /// The right side, rounded for display.
    pub right: String,
    /// By how much the sides miss the claim at most.
    pub residual: f64,
    /// What rounding allows.
    pub allowed: f64,
    /// Whether the claim holds.
    pub holds: bool,
}

impl LawReading {
    /// The reading of a claim.
    pub(super) fn of<T: Scalar>(reading: Reading<'_, T>) -> Self {
        Self {
            claim: reading.claim.to_owned(),
            left: side(reading.left),
            right: side(reading.right),
            residual: reading.residual,
            allowed: reading.allowed,
            holds: reading.holds,
        }
    }
}

/// The numbers of a side; of many only the first few.
fn side<T: Scalar>(numbers: &[T]) -> String {
    const FEW: usize = 6;
    let mut shown: Vec<String> = numbers.iter().take(FEW).map(short).collect();
    if numbers.len() > FEW {
        shown.push("…".to_owned());
    }
    shown.join(", ")
}

/// A number with few digits, if it is a decimal.
fn short<T: Scalar>(number: &T) -> String {
    let text = number.to_string();
    match text.parse::<f64>() {
        Ok(value) if text.len() > DIGITS + 2 => {
            let rounded: f64 = format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value);
            rounded.to_string()
        }
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(side(&[0.1 + 0.2, 2.0, -1.0 / 3.0]), "0.3, 2, -0.3333");
        assert_eq!(side(&[1.0; 9]), "1, 1, 1, 1, 1, 1, …");
    }
}
