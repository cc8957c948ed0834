//! The osculating circle.

use super::curvature::CurvatureError;
use crate::affine::{Point, Vector};

/// The circle that agrees with a curve in a point, in its tangent and in its curvature.
///
/// ```text
/// m = c(t) + n/κ,   r = 1/κ
/// ```
///
/// with the unit normal n to the side to which the curve turns, and κ > 0.
/// It comes from [`PlaneCurvature::osculating_circle`](super::PlaneCurvature::osculating_circle) and from
/// [`SpaceCurvature::osculating_circle`](super::SpaceCurvature::osculating_circle).
///
/// Source: `farin2002`, §10.2; `compendium`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OsculatingCircle<const D: usize> {
    centre: Point<f64, D>,
    radius: f64,
    tangent: Vector<f64, D>,
    normal: Vector<f64, D>,
}

impl<const D: usize> OsculatingCircle<D> {
    /// The circle through `point` with the unit vectors `tangent` and `normal`.
    pub(crate) fn new(
        parameter: f64,
        point: Point<f64, D>,
        tangent: Vector<f64, D>,
        normal: Vector<f64, D>,
        curvature: f64,
    ) -> Result<Self, CurvatureError> {
        if curvature == 0.0 {
            return Err(CurvatureError::Straight { parameter });
        }
        let radius = 1.0 / curvature;
        let centre = point + normal * radius;
        if !radius.is_finite() || centre.coordinates().iter().any(|x| !x.is_finite()) {
            return Err(CurvatureError::OutOfRange { parameter });
        }
        Ok(Self {
            centre,
            radius,
            tangent,
            normal,
        })
    }

    /// The centre of curvature m.
    #[must_use]
    pub fn centre(&self) -> Point<f64, D> {
        self.centre
    }

    /// The radius of curvature 1/|κ|.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The point of the circle at an angle in radians: 0 is the common point, and the angle grows
    /// in the direction of the curve.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::PlaneCurvature;
    ///
    /// let parabola = BezierCurve::new([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]].map(Point::new))?;
    /// let circle = parabola.osculating_circle(0.0)?;
    /// assert_eq!(circle.at(0.0), Point::new([0.0, 0.0]));
    /// let quarter = circle.at(std::f64::consts::FRAC_PI_2);
    /// assert!((quarter - Point::new([0.5, 0.5])).norm() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn at(&self, angle: f64) -> Point<f64, D> {
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        self.centre + self.tangent * (self.radius * sine) - self.normal * (self.radius * cosine)
    }
}
