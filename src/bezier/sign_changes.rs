//! Sign changes, and the rule of Descartes in Bernstein form.

use crate::scalar::OrderedScalar;

/// How often the sign changes along numbers; zeros do not count.
///
/// A polynomial in Bernstein form has at most as many zeros in (0, 1), counted with their
/// multiplicities, as its control values have sign changes, and an even number fewer if fewer.
///
/// # Examples
///
/// ```
/// use cagd::bezier::sign_changes;
///
/// assert_eq!(sign_changes(&[1.0, -1.0, 0.0, -2.0, 3.0]), 2);
/// assert_eq!(sign_changes(&[0.0, 1.0, 0.0, 1.0]), 0);
/// assert_eq!(sign_changes::<f64>(&[]), 0);
/// ```
///
/// Source: `prautzsch2002`, §2.8.
#[must_use]
pub fn sign_changes<T: OrderedScalar>(values: &[T]) -> usize {
    let zero = T::zero();
    let signs: Vec<bool> = values
        .iter()
        .filter(|value| **value != zero)
        .map(|value| *value > zero)
        .collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}
