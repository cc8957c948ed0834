//! A law beside a figure: both sides, in numbers that a reader can take in.

use crate::law::{Reading, Relation};
use crate::scalar::Scalar;

/// How many significant digits a side is shown with.
const DIGITS: usize = 4;

/// One claim of a law, for the values that a figure is drawn with.
#[derive(Debug, Clone, PartialEq)]
pub struct LawReading {
    /// The id of the statement that the law is of.
    pub statement: String,
    /// The panel that shows what the law is about.
    pub panel: String,
    /// What is claimed.
    pub claim: String,
    /// How the sides compare.
    pub relation: Relation,
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
    /// The reading of a claim of the law of a statement.
    pub(super) fn of<T: Scalar>(statement: &str, panel: &str, reading: Reading<'_, T>) -> Self {
        Self {
            statement: statement.to_owned(),
            panel: panel.to_owned(),
            claim: reading.claim.to_owned(),
            relation: reading.relation,
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
    const FEW: usize = 4;
    let mut shown: Vec<String> = numbers.iter().take(FEW).map(short).collect();
    if numbers.len() > FEW {
        shown.push("…".to_owned());
    }
    shown.join(", ")
}

/// A number with few digits; a fraction as a decimal.
fn short<T: Scalar>(number: &T) -> String {
    let text = number.to_string();
    match text.parse() {
        Ok(value) => readable(value),
        // Both parts of a fraction may be too large for 64 bits, where their quotient is not.
        Err(_) if text.contains('/') => {
            let sign = if text.starts_with('-') { -1.0 } else { 1.0 };
            readable(sign * number.magnitude())
        }
        Err(_) => text,
    }
}

/// A number as a reader wants to see it: four digits, and a power of ten where there would be many zeros.
pub(crate) fn readable(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{}", x + 0.0);
    }
    if !(1e-4..1e7).contains(&x.abs()) {
        return power_of_ten(x);
    }
    let rounded: f64 = format!("{x:.*e}", DIGITS - 1).parse().unwrap_or(x);
    rounded.to_string().replace('-', "−")
}

/// A very small or very large number, like 2.2·10⁻¹⁶.
pub(crate) fn power_of_ten(x: f64) -> String {
    let written = format!("{x:.1e}").replace('-', "−");
    match written.split_once('e') {
        Some((digits, "0")) => digits.to_owned(),
        Some((digits, exponent)) => {
            let raised = exponent.chars().map(|sign| match sign {
                '−' => '⁻',
                digit => digit.to_digit(10).map_or(digit, |d| RAISED[d as usize]),
            });
            format!("{digits}·10{}", raised.collect::<String>())
        }
        None => written,
    }
}

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::BigRational;

    #[test]
    fn numbers_are_short() {
        assert_eq!(side(&[0.1 + 0.2, 2.0, -1.0 / 3.0]), "0.3, 2, −0.3333");
        assert_eq!(side(&[3.5276, -0.0, 8.88e-15]), "3.528, 0, 8.9·10⁻¹⁵");
        assert_eq!(side(&[BigRational::from_ratio(-7, 3)]), "−2.333");
        assert_eq!(side(&[1.0; 9]), "1, 1, 1, 1, …");
        let huge = num_traits::pow(<BigRational as Scalar>::from_integer(2), 1100);
        let near_a_half = (&huge - BigRational::from_ratio(1, 1)) / (-&huge - &huge);
        assert_eq!(side(&[near_a_half]), "−0.5");
    }
}
