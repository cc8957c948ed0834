//! Derivatives of Bézier curves: hodographs, whose control points are vectors.

use super::curve::BezierCurve;
use crate::affine::{Affine, Linear};
use crate::scalar::Scalar;

impl<P: Affine> BezierCurve<P> {
    /// The derivative b′ with respect to the parameter of the domain [a, b].
    ///
    /// ```text
    /// b′(u) = n/(b − a) · Σᵢ (bᵢ₊₁ − bᵢ)·Bᵢⁿ⁻¹(t)
    /// ```
    ///
    /// Its control points are vectors, so its values are.
    /// The derivative of a curve of degree 0 is the constant curve of the zero vector.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{Point, Vector};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]].map(Point::new))?;
    /// let hodograph = curve.derivative();
    /// assert_eq!(hodograph.control_points(), [Vector::from([2.0, 4.0]), Vector::from([4.0, 0.0])]);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §5.3.
    #[must_use]
    pub fn derivative(&self) -> BezierCurve<P::Difference> {
        let degree = self.degree();
        if degree == 0 {
            let point = &self.control_points()[0];
            return BezierCurve::trusted(self.domain().clone(), vec![point.difference(point)]);
        }
        let factor = P::Scalar::from_integer(degree as i64) / self.domain().length();
        let differences = self
            .control_points()
            .windows(2)
            .map(|pair| pair[1].difference(&pair[0]).scaled(factor.clone()));
        BezierCurve::trusted(self.domain().clone(), differences.collect())
    }
}
