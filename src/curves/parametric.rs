//! What a parametric curve is.

use crate::affine::{Affine, Interval};

/// The numbers of a curve: of its parameter and of its coordinates.
pub type Number<C> = <<C as ParametricCurve>::Point as Affine>::Scalar;

/// The derivative vectors of a curve.
pub type Tangent<C> = <<C as ParametricCurve>::Point as Affine>::Difference;

/// A curve given by a parametrisation: a domain, a point and derivative vectors at each parameter.
///
/// A point and a derivative have different types: positions are points, velocities are vectors.
///
/// # Examples
///
/// The unit circle as a parametric curve has the curvature 1 everywhere.
///
/// ```
/// use cagd::affine::{Interval, Point, Vector};
/// use cagd::curves::{ParametricCurve, PlaneCurvature};
///
/// struct UnitCircle;
///
/// impl ParametricCurve for UnitCircle {
///     type Point = Point<f64, 2>;
///
///     fn domain(&self) -> Interval<f64> {
///         Interval::new(0.0, std::f64::consts::TAU).expect("two different ends")
///     }
///
///     fn at(&self, t: f64) -> Point<f64, 2> {
///         Point::new([t.cos(), t.sin()])
///     }
///
///     fn derivatives<const K: usize>(&self, t: f64) -> [Vector<f64, 2>; K] {
///         // Each derivative turns the vector by a right angle.
///         let mut vector = Vector::from([t.cos(), t.sin()]);
///         std::array::from_fn(|_| {
///             vector = Vector::from([-vector[1], vector[0]]);
///             vector
///         })
///     }
/// }
///
/// assert!((UnitCircle.curvature(1.0)? - 1.0).abs() < 1e-15);
/// # Ok::<(), cagd::curves::CurvatureError>(())
/// ```
///
/// Source: `farin2002`, §10.1.
pub trait ParametricCurve {
    /// What the curve consists of.
    type Point: Affine;

    /// The interval of parameters on which the curve is meant.
    fn domain(&self) -> Interval<Number<Self>>;

    /// The point at the parameter `t`.
    ///
    /// Outside the domain the formula is continued where it can be.
    fn at(&self, t: Number<Self>) -> Self::Point;

    /// The first K derivative vectors c′(t), c″(t), ….
    ///
    /// How many is told by the type: `let [first, second] = curve.derivatives(t);`.
    fn derivatives<const K: usize>(&self, t: Number<Self>) -> [Tangent<Self>; K];
}
