//! Polylines that sample a curve.

use std::num::NonZeroUsize;

use super::ParametricCurve;
use super::parametric::Number;
use crate::scalar::Scalar;

/// The points at the parameters that divide the domain into `segments` equal parts, both ends included.
///
/// ```text
/// c(uₖ),   uₖ = (1 − k/m)·a + (k/m)·b,   k = 0 … m
/// ```
///
/// Equal steps in the parameter are not equal steps along the curve, and no error bound comes with
/// them: a bound needs to know more about the curve than its points.
///
/// # Examples
///
/// ```
/// use std::num::NonZeroUsize;
///
/// use cagd::affine::Point;
/// use cagd::bezier::BezierCurve;
/// use cagd::curves::polyline;
///
/// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new))?;
/// let points = polyline(&curve, NonZeroUsize::new(2).expect("2 is not 0"));
/// assert_eq!(points, [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]].map(Point::new));
/// # Ok::<(), cagd::bezier::BezierError>(())
/// ```
///
/// Source: `compendium`.
#[must_use]
pub fn polyline<C: ParametricCurve + ?Sized>(curve: &C, segments: NonZeroUsize) -> Vec<C::Point> {
    let domain = curve.domain();
    let count = segments.get() as i64;
    (0..=count)
        .map(|k| curve.at(domain.global(Number::<C>::from_ratio(k, count))))
        .collect()
}
