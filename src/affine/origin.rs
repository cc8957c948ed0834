//! What sums of points are to a reader who has chosen an origin.

use num_traits::Zero;

use super::{Affine, Linear};

/// The point O + Σ αᵢ·(Aᵢ − O) that a reader with the origin O finds; the αᵢ may have any sum.
///
/// Readers with different origins find the same point exactly if Σ αᵢ = 1.
///
/// # Examples
///
/// ```
/// use cagd::affine::point_seen_from;
///
/// // "Twice the point 2" of the number line.
/// assert_eq!(point_seen_from(&0.0, &[(2.0, 2.0)]), 4.0);
/// assert_eq!(point_seen_from(&1.0, &[(2.0, 2.0)]), 3.0);
///
/// // The midpoint of 2 and 8.
/// let midpoint = [(0.5, 2.0), (0.5, 8.0)];
/// assert_eq!(point_seen_from(&0.0, &midpoint), 5.0);
/// assert_eq!(point_seen_from(&1.0, &midpoint), 5.0);
/// ```
#[must_use]
pub fn point_seen_from<P: Affine>(origin: &P, terms: &[(P::Scalar, P)]) -> P {
    origin.translated(&vector_seen_from(origin, terms))
}

/// The vector Σ αᵢ·(Aᵢ − O) that a reader with the origin O finds; the αᵢ may have any sum.
///
/// Readers with different origins find the same vector exactly if Σ αᵢ = 0.
///
/// # Examples
///
/// ```
/// use cagd::affine::vector_seen_from;
///
/// let from_2_to_8 = [(-1.0, 2.0), (1.0, 8.0)];
/// assert_eq!(vector_seen_from(&0.0, &from_2_to_8), 6.0);
/// assert_eq!(vector_seen_from(&1.0, &from_2_to_8), 6.0);
/// ```
#[must_use]
pub fn vector_seen_from<P: Affine>(origin: &P, terms: &[(P::Scalar, P)]) -> P::Difference {
    let zero = P::Difference::from_fn(|_| P::Scalar::zero());
    terms.iter().fold(zero, |sum, (weight, point)| {
        sum.translated(&point.difference(origin).scaled(weight.clone()))
    })
}
