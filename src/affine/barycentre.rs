//! Barycentres: where weighted points balance.

use num_traits::Zero;

use super::combination::{check_terms, sums_to, weight_sum};
use super::{Affine, CombinationError, vector_seen_from};
use crate::scalar::Scalar;

/// The barycentre of weighted points: the affine combination with the weights divided by their sum W.
///
/// ```text
/// G = Σ (wᵢ/W)·Aᵢ,   so that   Σ wᵢ·(Aᵢ − G) = 0
/// ```
///
/// It is computed from the first point, as A₀ + Σ wᵢ·(Aᵢ − A₀) / W.
///
/// # Errors
///
/// [`CombinationError::Empty`] if there is no point,
/// [`CombinationError::NotFinite`] if a weight or a coordinate is not finite,
/// [`CombinationError::NoWeight`] if the weights sum to 0 (for rounded weights: if rounding cannot tell the sum from 0),
/// [`CombinationError::Overflow`] if a number on the way is beyond the range of the number type.
///
/// # Examples
///
/// ```
/// use cagd::affine::{CombinationError, Point, barycentre};
///
/// let [a, b] = [[0.0, 0.0], [6.0, 3.0]].map(Point::new);
/// assert_eq!(barycentre(&[(1.0, a), (2.0, b)])?, Point::new([4.0, 2.0]));
/// assert_eq!(barycentre(&[(10.0, a), (20.0, b)])?, Point::new([4.0, 2.0]), "only ratios count");
/// assert_eq!(barycentre(&[(1.0, a), (-1.0, b)]), Err(CombinationError::NoWeight { count: 2 }));
/// # Ok::<(), CombinationError>(())
/// ```
pub fn barycentre<P: Affine>(masses: &[(P::Scalar, P)]) -> Result<P, CombinationError> {
    const WHAT: &str = "a barycentre";
    check_terms(WHAT, masses)?;
    if sums_to(masses.iter().map(|(weight, _)| weight), P::Scalar::zero()) {
        return Err(CombinationError::NoWeight {
            count: masses.len(),
        });
    }
    let start = &masses[0].1;
    let total = weight_sum(masses);
    let moment = vector_seen_from(start, masses);
    let way = P::Difference::from_fn(|k| moment.coordinates()[k].clone() / total.clone());
    let centre = start.translated(&way);
    // A total beyond the range would put the barycentre at the first point.
    if total.is_finite() && centre.coordinates().iter().all(Scalar::is_finite) {
        Ok(centre)
    } else {
        Err(CombinationError::Overflow { what: WHAT })
    }
}
