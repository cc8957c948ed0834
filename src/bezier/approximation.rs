//! Bernstein approximation of a function.

use super::curve::{BezierCurve, BezierError};
use crate::affine::Affine;
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The Bernstein approximation of degree m of a function F on [0, 1].
    ///
    /// ```text
    /// B_m(F; t) = Σᵢ F(i/m)·Bᵢᵐ(t),   i = 0 … m
    /// ```
    ///
    /// It is the Bézier curve whose control points are the values of F at the equally spaced
    /// parameters i/m. For continuous F it converges uniformly to F.
    ///
    /// # Errors
    ///
    /// [`BezierError::NoControlPoints`] for m = 0 (there is no parameter i/0), and
    /// [`BezierError::NotFinite`] if a value of F is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// let square = BezierCurve::bernstein_approximation(|t: f64| t * t, 2)?;
    /// // B₂(t²) is not t² but t² + t(1 − t)/2.
    /// assert_eq!(square.at(0.5), 0.375);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §6.3.
    pub fn bernstein_approximation(
        function: impl Fn(P::Scalar) -> P,
        degree: usize,
    ) -> Result<Self, BezierError> {
        if degree == 0 {
            return Err(BezierError::NoControlPoints);
        }
        Self::new((0..=degree).map(|i| function(P::Scalar::from_ratio(i as i64, degree as i64))))
    }
}

/// The point at `t` in [0, 1] of the polygon through `vertices`, vertex i at i/m.
///
/// ```text
/// F_m(t) = (i + 1 − m·t)·bᵢ + (m·t − i)·bᵢ₊₁   on [i/m, (i + 1)/m]
/// ```
///
/// Outside [0, 1] the first and the last leg are extended. A single vertex is a constant.
///
/// # Panics
///
/// If there is no vertex.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::bezier::polygon_at;
///
/// let polygon = [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]].map(Point::new);
/// assert_eq!(polygon_at(&polygon, 0.25), Point::new([1.0, 2.0]));
/// assert_eq!(polygon_at(&polygon, 1.0), Point::new([4.0, 0.0]));
/// ```
#[must_use]
pub fn polygon_at<P>(vertices: &[P], t: P::Scalar) -> P
where
    P: Affine,
    P::Scalar: PartialOrd,
{
    let legs = vertices.len() - 1;
    if legs == 0 {
        return vertices[0].clone();
    }
    let position = P::Scalar::from_integer(legs as i64) * t;
    let leg = (1..legs)
        .take_while(|&i| P::Scalar::from_integer(i as i64) <= position)
        .count();
    let local = position - P::Scalar::from_integer(leg as i64);
    vertices[leg].lerp(&vertices[leg + 1], local)
}
