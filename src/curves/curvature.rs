//! Curvature of plane and space curves, and torsion.
//!
//! ```text
//! plane   κ = det(c′, c″)/‖c′‖³           with a sign: positive where the curve turns left
//! space   κ = ‖c′ × c″‖/‖c′‖³             without a sign
//!         τ = det(c′, c″, c‴)/‖c′ × c″‖²
//! ```
//!
//! None of them changes with the parametrisation, but for the sign of the plane curvature when the
//! curve is run through backwards.

use thiserror::Error;

use super::ParametricCurve;
use super::osculating_circle::OsculatingCircle;
use super::range::{Scaled, cross, determinant};
use crate::affine::{Point, Vector};
use crate::scalar::{OrderedScalar, Scalar};

/// Curvature of curves in the plane.
pub trait PlaneCurvature: ParametricCurve<Point = Point<f64, 2>> {
    /// The curvature κ = det(c′, c″)/‖c′‖³ at `t`, positive where the curve turns left.
    ///
    /// From the derivative vectors it is computed with a relative error of at most 8u, u = 2⁻⁵³
    /// (a determinant by Kahan's method 2u, the cube of a length 5u, the quotient u). The vectors are
    /// scaled by powers of two first: coordinates of 1e±150 need no care.
    /// A curvature below the smallest normal number is rounded to a multiple of the smallest number.
    ///
    /// # Errors
    ///
    /// [`CurvatureError::Singular`] if c′(t) = 0,
    /// [`CurvatureError::NotFinite`] if `t` or a derivative is not finite,
    /// [`CurvatureError::OutOfRange`] if κ itself is beyond the range of `f64`.
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::{CurvatureError, PlaneCurvature};
    ///
    /// let curve = |points: [[f64; 2]; 3]| BezierCurve::new(points.map(Point::new));
    /// assert_eq!(curve([[0.0, 0.0], [1.0, 0.0], [2.0, 2.0]])?.curvature(0.0)?, 1.0);
    ///
    /// let stuck = curve([[0.0, 0.0], [0.0, 0.0], [1.0, 1.0]])?;
    /// assert_eq!(stuck.curvature(0.0), Err(CurvatureError::Singular { parameter: 0.0 }));
    /// assert!(matches!(stuck.curvature(f64::NAN), Err(CurvatureError::NotFinite { .. })));
    ///
    /// let tiny = curve([[0.0, 0.0], [1e-310, 0.0], [1e-310, 1e-310]])?;
    /// assert!(matches!(tiny.curvature(0.0), Err(CurvatureError::OutOfRange { .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `farin2002`, §10.2; `compendium`.
    fn curvature(&self, t: f64) -> Result<f64, CurvatureError> {
        let [first, second] = finite(t, self.derivatives(t))?;
        let speed =
            Scaled::<2>::new(first.as_slice()).ok_or(CurvatureError::Singular { parameter: t })?;
        let Some(acceleration) = Scaled::<2>::new(second.as_slice()) else {
            return Ok(0.0);
        };
        let ([a, b], [c, d]) = (speed.coordinates, acceleration.coordinates);
        let square = speed.square();
        in_range(
            t,
            determinant(a, b, c, d) / (square * libm::sqrt(square)),
            acceleration.exponent - 2 * speed.exponent,
        )
    }

    /// The circle that agrees with the curve at `t` in point, tangent and curvature.
    ///
    /// # Errors
    ///
    /// As [`curvature`](Self::curvature), and [`CurvatureError::Straight`] if κ = 0: then the tangent
    /// takes the place of the circle.
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::{CurvatureError, PlaneCurvature};
    ///
    /// let parabola = BezierCurve::new([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]].map(Point::new))?;
    /// let circle = parabola.osculating_circle(0.0)?;
    /// assert_eq!((circle.centre(), circle.radius()), (Point::new([0.0, 0.5]), 0.5));
    ///
    /// let line = BezierCurve::new([[0.0, 0.0], [1.0, 0.0]].map(Point::new))?;
    /// assert_eq!(line.osculating_circle(0.5), Err(CurvatureError::Straight { parameter: 0.5 }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn osculating_circle(&self, t: f64) -> Result<OsculatingCircle<2>, CurvatureError> {
        let curvature = self.curvature(t)?;
        let [first] = finite(t, self.derivatives(t))?;
        let tangent = direction(t, first)?;
        let left = Vector::from([-tangent[1], tangent[0]]);
        OsculatingCircle::new(
            t,
            self.at(t),
            tangent,
            if curvature < 0.0 { -left } else { left },
            curvature.abs(),
        )
    }
}

impl<C: ParametricCurve<Point = Point<f64, 2>>> PlaneCurvature for C {}

/// Curvature and torsion of curves in space.
pub trait SpaceCurvature: ParametricCurve<Point = Point<f64, 3>> {
    /// The curvature κ = ‖c′ × c″‖/‖c′‖³ at `t`, never negative.
    ///
    /// From the derivative vectors it is computed with a relative error of at most 16u, u = 2⁻⁵³
    /// (each coordinate of the cross product 2u, its length 5u in all, the cube of a length 7u, the
    /// quotient u). Scaling and small values as in the plane.
    ///
    /// # Errors
    ///
    /// As [`PlaneCurvature::curvature`].
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::SpaceCurvature;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 2.0]].map(Point::new))?;
    /// assert_eq!(curve.curvature(0.0)?, 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `farin2002`, §10.2; `compendium`.
    fn curvature(&self, t: f64) -> Result<f64, CurvatureError> {
        let [first, second] = finite(t, self.derivatives(t))?;
        let speed =
            Scaled::<3>::new(first.as_slice()).ok_or(CurvatureError::Singular { parameter: t })?;
        let Some(acceleration) = Scaled::<3>::new(second.as_slice()) else {
            return Ok(0.0);
        };
        let Some(binormal) =
            Scaled::<3>::new(&cross(&speed.coordinates, &acceleration.coordinates))
        else {
            return Ok(0.0);
        };
        let square = speed.square();
        in_range(
            t,
            libm::sqrt(binormal.square()) / (square * libm::sqrt(square)),
            binormal.exponent + acceleration.exponent - 2 * speed.exponent,
        )
    }

    /// The torsion τ = det(c′, c″, c‴)/‖c′ × c″‖² at `t`: how fast the curve leaves its osculating plane.
    ///
    /// Positive for a right-handed screw. From the derivative vectors it is computed with an error of
    /// at most 16u·‖c‴‖/‖c′ × c″‖: of a determinant of three vectors no better bound is known here.
    ///
    /// # Errors
    ///
    /// As [`PlaneCurvature::curvature`], and [`CurvatureError::Straight`] if c′ × c″ = 0.
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::SpaceCurvature;
    ///
    /// // (t, t², t³) has the torsion 3 at t = 0.
    /// let third = 1.0 / 3.0;
    /// let curve = BezierCurve::new(
    ///     [[0.0, 0.0, 0.0], [third, 0.0, 0.0], [2.0 * third, third, 0.0], [1.0, 1.0, 1.0]].map(Point::new),
    /// )?;
    /// assert!((curve.torsion(0.0)? - 3.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Source: `farin2002`, §10.2; `compendium`.
    fn torsion(&self, t: f64) -> Result<f64, CurvatureError> {
        let [first, second, third] = finite(t, self.derivatives(t))?;
        let speed =
            Scaled::<3>::new(first.as_slice()).ok_or(CurvatureError::Singular { parameter: t })?;
        let straight = CurvatureError::Straight { parameter: t };
        let acceleration = Scaled::<3>::new(second.as_slice()).ok_or(straight)?;
        let binormal = Scaled::<3>::new(&cross(&speed.coordinates, &acceleration.coordinates))
            .ok_or(straight)?;
        let Some(jerk) = Scaled::<3>::new(third.as_slice()) else {
            return Ok(0.0);
        };
        let determinant: f64 = std::iter::zip(binormal.coordinates, jerk.coordinates)
            .map(|(x, y)| x * y)
            .sum();
        in_range(
            t,
            determinant / binormal.square(),
            jerk.exponent - binormal.exponent - speed.exponent - acceleration.exponent,
        )
    }

    /// The circle in the osculating plane that agrees with the curve at `t` in point, tangent and curvature.
    ///
    /// # Errors
    ///
    /// As [`PlaneCurvature::osculating_circle`].
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    /// use cagd::curves::SpaceCurvature;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 2.0]].map(Point::new))?;
    /// assert_eq!(curve.osculating_circle(0.0)?.centre(), Point::new([0.0, 0.0, 1.0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn osculating_circle(&self, t: f64) -> Result<OsculatingCircle<3>, CurvatureError> {
        let curvature = self.curvature(t)?;
        let [first, second] = finite(t, self.derivatives(t))?;
        let tangent = direction(t, first)?;
        let straight = CurvatureError::Straight { parameter: t };
        let acceleration = Scaled::<3>::new(second.as_slice()).ok_or(straight)?;
        let tangent_coordinates = [tangent[0], tangent[1], tangent[2]];
        let binormal = cross(&tangent_coordinates, &acceleration.coordinates);
        if binormal == [0.0; 3] {
            return Err(straight);
        }
        let binormal = direction(t, Vector::from(binormal))?;
        let normal = cross(
            &[binormal[0], binormal[1], binormal[2]],
            &tangent_coordinates,
        );
        OsculatingCircle::new(t, self.at(t), tangent, Vector::from(normal), curvature)
    }
}

impl<C: ParametricCurve<Point = Point<f64, 3>>> SpaceCurvature for C {}

/// The square of the curvature of a plane curve with the sign of the curvature, κ·|κ|.
///
/// ```text
/// κ·|κ| = det(c′, c″)·|det(c′, c″)|/⟨c′, c′⟩³
/// ```
///
/// It has no root and is exact for exact numbers. `None` at a singular point, c′ = 0.
///
/// # Examples
///
/// ```
/// use cagd::affine::Vector;
/// use cagd::curves::curvature::plane_curvature_squared;
///
/// let vector = |x: f64, y: f64| Vector::from([x, y]);
/// assert_eq!(plane_curvature_squared(&vector(2.0, 0.0), &vector(0.0, -8.0)), Some(-4.0));
/// assert_eq!(plane_curvature_squared(&vector(0.0, 0.0), &vector(0.0, 8.0)), None);
/// ```
#[must_use]
pub fn plane_curvature_squared<T: OrderedScalar>(
    first: &Vector<T, 2>,
    second: &Vector<T, 2>,
) -> Option<T> {
    let determinant = first[0].clone() * second[1].clone() - first[1].clone() * second[0].clone();
    let square = square(first);
    (!square.is_zero()).then(|| {
        determinant.clone() * determinant.abs() / (square.clone() * square.clone() * square)
    })
}

/// The square of the curvature of a space curve, κ² = ‖c′ × c″‖²/⟨c′, c′⟩³.
///
/// It has no root and is exact for exact numbers. `None` at a singular point, c′ = 0.
///
/// # Examples
///
/// ```
/// use cagd::affine::Vector;
/// use cagd::curves::curvature::space_curvature_squared;
///
/// let (first, second) = (Vector::from([2.0, 0.0, 0.0]), Vector::from([1.0, 0.0, 8.0]));
/// assert_eq!(space_curvature_squared(&first, &second), Some(4.0));
/// ```
#[must_use]
pub fn space_curvature_squared<T: Scalar>(
    first: &Vector<T, 3>,
    second: &Vector<T, 3>,
) -> Option<T> {
    let speed = square(first);
    (!speed.is_zero())
        .then(|| square(&first.cross(second)) / (speed.clone() * speed.clone() * speed))
}

/// ⟨v, v⟩
fn square<T: Scalar, const D: usize>(vector: &Vector<T, D>) -> T {
    vector
        .iter()
        .fold(T::zero(), |sum, x| sum + x.clone() * x.clone())
}

/// Why a curve has no curvature, torsion or osculating circle at a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum CurvatureError {
    /// The derivative vanishes.
    #[error(
        "the curve is singular at {parameter}: its derivative is the zero vector there, so that it has no curvature; look at a neighbouring parameter"
    )]
    Singular {
        /// The parameter.
        parameter: f64,
    },
    /// The first two derivatives are linearly dependent.
    #[error(
        "the curve has curvature 0 at {parameter}: it has no osculating circle and no torsion there; use the tangent"
    )]
    Straight {
        /// The parameter.
        parameter: f64,
    },
    /// The parameter or a derivative is NaN or infinite.
    #[error(
        "the parameter {parameter} or a derivative there is not finite; use a finite parameter, or scale the curve down"
    )]
    NotFinite {
        /// The parameter.
        parameter: f64,
    },
    /// The result is beyond the range of `f64`.
    #[error(
        "the result at {parameter} is beyond the range of f64; scale the curve to a moderate size"
    )]
    OutOfRange {
        /// The parameter.
        parameter: f64,
    },
}

/// The derivatives, if they and the parameter are finite.
fn finite<const D: usize, const K: usize>(
    parameter: f64,
    derivatives: [Vector<f64, D>; K],
) -> Result<[Vector<f64, D>; K], CurvatureError> {
    let finite = derivatives
        .iter()
        .all(|vector| vector.iter().all(|x| x.is_finite()));
    if parameter.is_finite() && finite {
        Ok(derivatives)
    } else {
        Err(CurvatureError::NotFinite { parameter })
    }
}

/// `value`·2^`exponent`, if that is finite.
fn in_range(parameter: f64, value: f64, exponent: i32) -> Result<f64, CurvatureError> {
    let result = libm::scalbn(value, exponent);
    if result.is_finite() {
        Ok(result)
    } else {
        Err(CurvatureError::OutOfRange { parameter })
    }
}

/// The unit vector in the direction of a vector.
fn direction<const D: usize>(
    parameter: f64,
    vector: Vector<f64, D>,
) -> Result<Vector<f64, D>, CurvatureError> {
    let scaled =
        Scaled::<D>::new(vector.as_slice()).ok_or(CurvatureError::Singular { parameter })?;
    Ok(Vector::from(scaled.coordinates) / libm::sqrt(scaled.square()))
}
