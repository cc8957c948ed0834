//! Linear, affine and convex combinations, told apart by their weights.

use super::combination::sums_to;
use crate::scalar::OrderedScalar;

/// What kind of combination weights make; each kind is a special case of the one before.
///
/// # Examples
///
/// ```
/// use cagd::affine::CombinationKind;
///
/// assert_eq!(CombinationKind::of(&[0.25, 0.75]), CombinationKind::Convex);
/// assert_eq!(CombinationKind::of(&[-1.0, 2.0]), CombinationKind::Affine);
/// assert_eq!(CombinationKind::of(&[1.0, 1.0]), CombinationKind::Linear);
/// assert!(CombinationKind::Convex > CombinationKind::Affine);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CombinationKind {
    /// The weights may be any numbers: of vectors it is a vector, of points it is nothing.
    Linear,
    /// The weights sum to 1: of points it is a point.
    Affine,
    /// The weights sum to 1, and none is negative: it is a mean.
    Convex,
}

impl CombinationKind {
    /// The most special kind of these weights.
    ///
    /// Rounded weights sum to 1 if they miss it by no more than n roundings and those of their sum, γₙ₊₁·Σ|wᵢ|.
    /// Weights that are not finite are of the kind `Linear`.
    #[must_use]
    pub fn of<T: OrderedScalar>(weights: &[T]) -> Self {
        if !sums_to(weights.iter(), T::one()) {
            Self::Linear
        } else if weights.iter().all(|weight| *weight >= T::zero()) {
            Self::Convex
        } else {
            Self::Affine
        }
    }
}
