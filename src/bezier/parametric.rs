//! A Bézier curve as a parametric curve: curvature, osculating circle, sampling come with it.

use super::curve::BezierCurve;
use crate::affine::{Affine, Interval};
use crate::curves::ParametricCurve;

/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::bezier::BezierCurve;
/// use cagd::curves::PlaneCurvature;
///
/// // The parabola (t, t²) has the curvature 2 at its vertex.
/// let parabola = BezierCurve::new([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]].map(Point::new))?;
/// assert_eq!(parabola.curvature(0.0)?, 2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl<P: Affine> ParametricCurve for BezierCurve<P> {
    type Point = P;

    fn domain(&self) -> Interval<P::Scalar> {
        BezierCurve::domain(self).clone()
    }

    fn at(&self, t: P::Scalar) -> P {
        BezierCurve::at(self, t)
    }

    fn derivatives<const K: usize>(&self, t: P::Scalar) -> [P::Difference; K] {
        BezierCurve::derivatives(self, t)
    }
}
