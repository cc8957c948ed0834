//! Bézier curves: control points and a parameter interval.

use std::fmt;

use thiserror::Error;

use crate::affine::{Affine, Interval, IntervalError, Point, Vector};
use crate::scalar::Scalar;

/// A Bézier curve of degree n over a parameter interval [a, b].
///
/// ```text
/// b(u) = Σᵢ bᵢ·Bᵢⁿ(t),   t = (u − a)/(b − a),   i = 0 … n
/// ```
///
/// The control points bᵢ may be points (a curve), vectors (the derivative of one) or numbers
/// (a polynomial in Bernstein form). They are never empty and always finite.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::bezier::BezierCurve;
///
/// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
/// assert_eq!(curve.degree(), 3);
/// assert_eq!(curve.at(0.5), Point::new([2.0, 3.0]));
/// # Ok::<(), cagd::bezier::BezierError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BezierCurve<P: Affine> {
    control_points: Vec<P>,
    domain: Interval<P::Scalar>,
}

/// A plane curve over `f64`.
pub type PlaneCurve = BezierCurve<Point<f64, 2>>;

/// The derivative of a curve of points: its control points are vectors.
pub type Hodograph<T, const D: usize> = BezierCurve<Vector<T, D>>;

impl<P: Affine> BezierCurve<P> {
    /// The curve over [0, 1] with these control points; one more than the degree.
    ///
    /// # Errors
    ///
    /// [`BezierError::NoControlPoints`] or [`BezierError::NotFinite`].
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::{BezierCurve, BezierError};
    ///
    /// let none: [Point<f64, 2>; 0] = [];
    /// assert_eq!(BezierCurve::new(none), Err(BezierError::NoControlPoints));
    ///
    /// let broken = BezierCurve::new([[0.0, 0.0], [f64::NAN, 1.0]].map(Point::new)).unwrap_err();
    /// assert_eq!(broken.to_string(), "control point 1 is not finite: (NaN, 1); every coordinate must be a finite number");
    /// ```
    pub fn new(control_points: impl IntoIterator<Item = P>) -> Result<Self, BezierError> {
        Self::on(Interval::unit(), control_points)
    }

    /// The curve over `domain` with these control points.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn on(
        domain: Interval<P::Scalar>,
        control_points: impl IntoIterator<Item = P>,
    ) -> Result<Self, BezierError> {
        let control_points: Vec<P> = control_points.into_iter().collect();
        if control_points.is_empty() {
            return Err(BezierError::NoControlPoints);
        }
        for (index, point) in control_points.iter().enumerate() {
            if !point.coordinates().iter().all(Scalar::is_finite) {
                return Err(BezierError::NotFinite {
                    index,
                    point: tuple(point),
                });
            }
        }
        Ok(Self {
            control_points,
            domain,
        })
    }

    /// A curve whose control points are known to be finite and not empty.
    pub(crate) fn trusted(domain: Interval<P::Scalar>, control_points: Vec<P>) -> Self {
        debug_assert!(!control_points.is_empty());
        Self {
            control_points,
            domain,
        }
    }

    /// The same control points over another interval.
    ///
    /// The trace stays, the speed changes by the ratio of the lengths.
    #[must_use]
    pub fn reparametrised(&self, domain: Interval<P::Scalar>) -> Self {
        Self::trusted(domain, self.control_points.clone())
    }

    /// The degree n, one less than the number of control points.
    ///
    /// It is the formal degree: the polynomial may have a smaller one.
    #[inline]
    #[must_use]
    pub fn degree(&self) -> usize {
        self.control_points.len() - 1
    }

    /// The control points b₀ … bₙ.
    #[inline]
    #[must_use]
    pub fn control_points(&self) -> &[P] {
        &self.control_points
    }

    /// The parameter interval.
    #[must_use]
    pub fn domain(&self) -> &Interval<P::Scalar> {
        &self.domain
    }
}

/// Why there is no Bézier curve, or no point of it.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum BezierError {
    /// The control polygon is empty.
    #[error("a Bézier curve of degree n needs n + 1 control points, found none; give at least one")]
    NoControlPoints,
    /// A control point has a coordinate that is NaN or infinite.
    #[error(
        "control point {index} is not finite: {point}; every coordinate must be a finite number"
    )]
    NotFinite {
        /// Which control point, counted from 0.
        index: usize,
        /// The point.
        point: String,
    },
    /// The parameter is NaN or infinite.
    #[error("the parameter must be a finite number, found {parameter}")]
    ParameterNotFinite {
        /// The parameter.
        parameter: String,
    },
    /// The result is beyond the range of the number type.
    #[error(
        "the value at the parameter {parameter} is beyond the range of the number type: {value}; scale the control points down"
    )]
    OutOfRange {
        /// The parameter.
        parameter: String,
        /// What the computation gave.
        value: String,
    },
    /// The ends of a parameter interval are not two different finite numbers.
    #[error(transparent)]
    Interval(#[from] IntervalError),
}

/// The coordinates as `(x, y, …)`.
pub(crate) fn tuple<P: Affine>(point: &P) -> String {
    let coordinates: Vec<String> = point
        .coordinates()
        .iter()
        .map(ToString::to_string)
        .collect();
    format!("({})", coordinates.join(", "))
}

/// Writes `b₀ = (…), b₁ = (…), … on [a, b]`.
impl<P: Affine> fmt::Display for BezierCurve<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points: Vec<String> = self.control_points.iter().map(tuple).collect();
        write!(
            f,
            "control points {} on [{}, {}]",
            points.join(", "),
            self.domain.start(),
            self.domain.end()
        )
    }
}
