//! Quadratic Bézier curves: parabolas, and what is left of them when the control points are collinear.

use num_traits::Zero;
use thiserror::Error;

use super::curve::BezierCurve;
use crate::affine::{Affine, Linear, Point, Vector};
use crate::scalar::{OrderedScalar, Scalar};

/// The polynomial form b(t) = o + t·v + t²·a of a quadratic curve, t in [0, 1] over its domain.
///
/// Read as a map, (x, y) ↦ o + x·v + y·a is affine, and it takes (t, t²) to b(t): it maps the
/// standard parabola y = x² to the curve. It is injective if and only if the control points are
/// not collinear; then the trace is an arc of a parabola and a is the direction of its axis.
///
/// # Examples
///
/// ```
/// use cagd::affine::{Point, Vector};
/// use cagd::bezier::{BezierCurve, ParabolaMap};
///
/// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]].map(Point::new))?;
/// let map = ParabolaMap::of(&curve)?;
/// assert_eq!(map.axis(), &Vector::from([1.0, -2.0]));
/// assert_eq!(map.apply(0.5, 0.25), curve.at(0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ParabolaMap<P: Affine> {
    origin: P,
    tangent: P::Difference,
    axis: P::Difference,
}

impl<P: Affine> ParabolaMap<P> {
    /// The map of a quadratic curve: o = b₀, v = 2(b₁ − b₀), a = b₂ − 2b₁ + b₀.
    ///
    /// # Errors
    ///
    /// [`QuadraticError::NotQuadratic`] if the curve has not exactly three control points.
    ///
    /// ```
    /// use cagd::bezier::{BezierCurve, ParabolaMap};
    ///
    /// let line = BezierCurve::new([0.0, 1.0])?;
    /// let error = ParabolaMap::of(&line).unwrap_err();
    /// assert_eq!(error.to_string(), "a quadratic Bézier curve has 3 control points, this one has 2; elevate or reduce its degree");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    pub fn of(curve: &BezierCurve<P>) -> Result<Self, QuadraticError> {
        let [start, middle, end] = curve.control_points() else {
            return Err(QuadraticError::NotQuadratic {
                found: curve.control_points().len(),
            });
        };
        let first = middle.difference(start);
        Ok(Self {
            origin: start.clone(),
            tangent: first.scaled(P::Scalar::from_integer(2)),
            axis: end.difference(middle).difference(&first),
        })
    }

    /// The point o + x·v + y·a.
    #[must_use]
    pub fn apply(&self, x: P::Scalar, y: P::Scalar) -> P {
        self.origin
            .translated(&self.tangent.scaled(x))
            .translated(&self.axis.scaled(y))
    }

    /// The image o of the vertex (0, 0) of the standard parabola: b₀.
    #[must_use]
    pub fn origin(&self) -> &P {
        &self.origin
    }

    /// The image v of (1, 0): the tangent at the start with respect to the local parameter.
    #[must_use]
    pub fn tangent(&self) -> &P::Difference {
        &self.tangent
    }

    /// The image a of (0, 1): the direction of the axis of the parabola, b₂ − 2b₁ + b₀.
    #[must_use]
    pub fn axis(&self) -> &P::Difference {
        &self.axis
    }

    /// The local parameter of the vertex of the parabola, −⟨v, a⟩/(2⟨a, a⟩): there the tangent is
    /// perpendicular to the axis.
    ///
    /// `None` if a = 0. The vertex need not lie on the arc t in [0, 1].
    #[must_use]
    pub fn vertex_parameter(&self) -> Option<P::Scalar> {
        let square = inner(&self.axis, &self.axis);
        if square.is_zero() {
            None
        } else {
            let twice = square.clone() + square;
            Some(-inner(&self.tangent, &self.axis) / twice)
        }
    }
}

impl<T: Scalar> ParabolaMap<Point<T, 2>> {
    /// The determinant det(v, a) = 2·det(b₁ − b₀, b₂ − b₁): 0 if and only if the control points are collinear.
    #[must_use]
    pub fn determinant(&self) -> T {
        let (v, a): (&Vector<T, 2>, &Vector<T, 2>) = (&self.tangent, &self.axis);
        v[0].clone() * a[1].clone() - v[1].clone() * a[0].clone()
    }

    /// The preimage (x, y) of a point, so that the point is on the parabola if and only if y = x².
    ///
    /// `None` if the control points are collinear.
    #[must_use]
    pub fn preimage(&self, point: &Point<T, 2>) -> Option<(T, T)> {
        let determinant = self.determinant();
        if determinant.is_zero() {
            return None;
        }
        let (v, a) = (&self.tangent, &self.axis);
        let w = point.clone() - self.origin.clone();
        let x = (w[0].clone() * a[1].clone() - w[1].clone() * a[0].clone()) / determinant.clone();
        let y = (v[0].clone() * w[1].clone() - v[1].clone() * w[0].clone()) / determinant;
        Some((x, y))
    }
}

/// What the trace of a quadratic curve over t in [0, 1] is.
#[derive(Debug, Clone, PartialEq)]
pub enum QuadraticTrace<T> {
    /// An arc of a parabola: the control points are not collinear.
    Parabola,
    /// A segment of a line, run through once.
    Segment,
    /// A segment of a line; the point turns back at this local parameter in (0, 1).
    Turning {
        /// Where b′ = 0.
        at: T,
    },
    /// A single point.
    Point,
}

impl<T: OrderedScalar, const D: usize> BezierCurve<Point<T, D>> {
    /// What the trace of this quadratic curve is.
    ///
    /// Decided on the control points without tolerance: for exact numbers exactly.
    /// For `f64` a polygon counts as collinear only if all determinants of b₁ − b₀ and b₂ − b₁ are computed as 0.
    ///
    /// # Errors
    ///
    /// [`QuadraticError::NotQuadratic`] if the curve has not exactly three control points.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::{BezierCurve, QuadraticTrace};
    ///
    /// let trace = |points: [[f64; 2]; 3]| -> Result<_, Box<dyn std::error::Error>> {
    ///     Ok(BezierCurve::new(points.map(Point::new))?.quadratic_trace()?)
    /// };
    /// assert_eq!(trace([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?, QuadraticTrace::Parabola);
    /// assert_eq!(trace([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]])?, QuadraticTrace::Segment);
    /// assert_eq!(trace([[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]])?, QuadraticTrace::Turning { at: 0.5 });
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn quadratic_trace(&self) -> Result<QuadraticTrace<T>, QuadraticError> {
        let map = ParabolaMap::of(self)?;
        let (v, a) = (map.tangent(), map.axis());
        let legs = [
            self.control_points()[1].difference(&self.control_points()[0]),
            self.control_points()[2].difference(&self.control_points()[1]),
        ];
        let collinear = (0..D).all(|i| {
            (0..i).all(|j| {
                legs[0][i].clone() * legs[1][j].clone() == legs[0][j].clone() * legs[1][i].clone()
            })
        });
        if !collinear {
            return Ok(QuadraticTrace::Parabola);
        }
        if a.iter().all(T::is_zero) {
            return Ok(if v.iter().all(T::is_zero) {
                QuadraticTrace::Point
            } else {
                QuadraticTrace::Segment
            });
        }
        // On the line, b′ = v + 2t·a vanishes at exactly one t, because a is not 0.
        let twice = inner(a, a) + inner(a, a);
        let at = -inner(v, a) / twice;
        Ok(if T::zero() < at && at < T::one() {
            QuadraticTrace::Turning { at }
        } else {
            QuadraticTrace::Segment
        })
    }
}

/// Why a curve is not treated as a quadratic one.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum QuadraticError {
    /// The curve has not exactly three control points.
    #[error(
        "a quadratic Bézier curve has 3 control points, this one has {found}; elevate or reduce its degree"
    )]
    NotQuadratic {
        /// How many there are.
        found: usize,
    },
}

fn inner<V: Linear>(left: &V, right: &V) -> V::Scalar {
    std::iter::zip(left.coordinates(), right.coordinates())
        .fold(V::Scalar::zero(), |sum, (x, y)| sum + x.clone() * y.clone())
}
