//! The modified Butterfly scheme for triangle meshes: its stencils and its rules.

use super::cosine::{CosineError, CosineOfTurn};
use crate::scalar::Scalar;

/// The weights of the eight-point stencil: an end of the edge 1/2, a vertex opposite to it 1/8, a wing −1/16.
///
/// ```text
///   wing ──── opposite ──── wing
///       ╲     ╱    ╲      ╱
///        ╲   ╱      ╲    ╱
///         end ────── end
///        ╱   ╲      ╱    ╲
///       ╱     ╲    ╱      ╲
///   wing ──── opposite ──── wing
/// ```
///
/// ```
/// use cagd::subdivision::butterfly_weights;
/// let [end, opposite, wing] = butterfly_weights::<f64>();
/// assert_eq!(2.0 * end + 2.0 * opposite + 4.0 * wing, 1.0);
/// ```
///
/// Source: `dyn1990`.
#[must_use]
pub fn butterfly_weights<T: Scalar>() -> [T; 3] {
    [8, 2, -1].map(|sixteenths| T::from_ratio(sixteenths, 16))
}

/// The weights s₀, …, s₍k₋₁₎ of the neighbours of a vertex of valence k ≠ 6 in the new point on the edge to neighbour 0.
///
/// The vertex itself has the weight 3/4 ([`butterfly_centre_weight`]), and the s_j sum to 1/4.
///
/// ```text
/// k ≥ 5:   s_j = (1/k)(1/4 + cos(2πj/k) + cos(4πj/k)/2)
/// k = 4:   3/8, 0, −1/8, 0
/// k = 3:   5/12, −1/12, −1/12
/// ```
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::butterfly_star_weights;
///
/// let ratio = BigRational::from_ratio;
/// assert_eq!(butterfly_star_weights(4)?, [ratio(3, 8), ratio(0, 1), ratio(-1, 8), ratio(0, 1)]);
/// assert_eq!(butterfly_star_weights(3)?, [ratio(5, 12), ratio(-1, 12), ratio(-1, 12)]);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or a weight is irrational and the type holds rational numbers only.
///
/// Source: `zorin1996`.
pub fn butterfly_star_weights<T: CosineOfTurn>(valence: usize) -> Result<Vec<T>, CosineError> {
    let list = |numerators: &[i64], denominator| {
        let weights = numerators.iter().map(|&n| T::from_ratio(n, denominator));
        Ok(weights.collect())
    };
    match valence {
        3 => list(&[5, -1, -1], 12),
        4 => list(&[3, 0, -1, 0], 8),
        _ => butterfly_cosine_formula(valence),
    }
}

/// The formula s_j = (1/k)(1/4 + cos(2πj/k) + cos(4πj/k)/2) at any valence, also where it gives the wrong weights.
///
/// It is right for k ≥ 5. Use [`butterfly_star_weights`].
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::butterfly_cosine_formula;
/// let ratio = BigRational::from_ratio;
/// let wrong = [ratio(7, 12), ratio(-1, 6), ratio(-1, 6)];
/// assert_eq!(butterfly_cosine_formula(3)?, wrong);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or a weight is irrational and the type holds rational numbers only.
pub fn butterfly_cosine_formula<T: CosineOfTurn>(valence: usize) -> Result<Vec<T>, CosineError> {
    // Asks for the first cosine even where no weight is wanted, so that valence 0 is refused.
    T::cosine_of_turn(0, valence)?;
    let count = i64::try_from(valence).unwrap_or(i64::MAX);
    (0..count)
        .map(|j| {
            let once = T::cosine_of_turn(j, valence)?;
            let twice = T::cosine_of_turn(2 * j, valence)?;
            let sum = T::from_ratio(1, 4) + once + twice * T::from_ratio(1, 2);
            Ok(sum / T::from_integer(count))
        })
        .collect()
}

/// The weight 3/4 of the extraordinary vertex itself.
///
/// ```
/// use cagd::subdivision::{butterfly_centre_weight, butterfly_star_weights};
/// let star: f64 = butterfly_star_weights::<f64>(3)?.iter().sum();
/// assert!((butterfly_centre_weight::<f64>() + star - 1.0).abs() < 1e-15);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
#[must_use]
pub fn butterfly_centre_weight<T: Scalar>() -> T {
    T::from_ratio(3, 4)
}
