//! Numbers and points as LaTeX, for what a chapter computes.

use crate::affine::Affine;
use crate::scalar::{BigRational, OrderedScalar};

/// A rational number as LaTeX: a whole number as it is, a fraction as `\tfrac{p}{q}`.
///
/// ```
/// use cagd::book::tex::fraction;
/// use cagd::scalar::{BigRational, Scalar};
///
/// assert_eq!(fraction(&BigRational::from_ratio(-3, 4)), r"-\tfrac{3}{4}");
/// assert_eq!(fraction(&BigRational::from_ratio(8, 4)), "2");
/// ```
#[must_use]
pub fn fraction(number: &BigRational) -> String {
    if number.is_integer() {
        return number.to_string();
    }
    let sign = if number.numer().sign() == num_bigint::Sign::Minus {
        "-"
    } else {
        ""
    };
    format!(
        r"{sign}\tfrac{{{}}}{{{}}}",
        number.numer().magnitude(),
        number.denom()
    )
}

/// A rational number as a decimal with `digits` digits after the point, trailing zeros dropped.
///
/// ```
/// use cagd::book::tex::decimal;
/// use cagd::scalar::{BigRational, Scalar};
///
/// assert_eq!(decimal(&BigRational::from_ratio(4536, 1000), 6), "4.536");
/// assert_eq!(decimal(&BigRational::from_ratio(-2, 3), 3), "-0.667");
/// ```
#[must_use]
pub fn decimal(number: &BigRational, digits: usize) -> String {
    let text = format!("{:.digits$}", number.to_f64());
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    if text == "-0" {
        "0".into()
    } else {
        text.into()
    }
}

/// A point or vector as `(x, y)`, its coordinates written by `number`.
///
/// ```
/// use cagd::affine::Point;
/// use cagd::book::tex::{fraction, point};
/// use cagd::scalar::{BigRational, Scalar};
///
/// let middle = Point::new([BigRational::from_ratio(1, 2), BigRational::from_ratio(3, 1)]);
/// assert_eq!(point(&middle, fraction), r"(\tfrac{1}{2}, 3)");
/// ```
#[must_use]
pub fn point<P: Affine>(point: &P, number: impl Fn(&P::Scalar) -> String) -> String {
    let coordinates: Vec<String> = point.coordinates().iter().map(number).collect();
    format!("({})", coordinates.join(", "))
}
