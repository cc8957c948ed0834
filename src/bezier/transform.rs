//! Affine images and reversal of Bézier curves.

use super::curve::{BezierCurve, BezierError};
use crate::affine::{Affine, AffineMap, Point};
use crate::scalar::Scalar;

impl<T: Scalar, const D: usize> BezierCurve<Point<T, D>> {
    /// The image of the curve under an affine map: the Bézier curve of the images of the control points.
    ///
    /// ```text
    /// α(b(u)) = Σ α(bᵢ)·Bᵢⁿ(t)
    /// ```
    ///
    /// # Errors
    ///
    /// [`BezierError::NotFinite`] if an image is beyond the range of the number type.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::{AffineMap, Point};
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new))?;
    /// let quarter_turn = AffineMap::new([[0.0, -1.0], [1.0, 0.0]], [0.0, 0.0]);
    /// let image = curve.mapped(&quarter_turn)?;
    /// assert_eq!(image.at(0.5), quarter_turn.point(&curve.at(0.5)));
    ///
    /// let magnified = curve.mapped(&AffineMap::new([[1e308, 0.0], [0.0, 1e308]], [0.0, 0.0]));
    /// assert!(magnified.is_err());
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §4.3.
    pub fn mapped<const E: usize>(
        &self,
        map: &AffineMap<T, D, E>,
    ) -> Result<BezierCurve<Point<T, E>>, BezierError> {
        let images = self.control_points().iter().map(|point| map.point(point));
        BezierCurve::on(self.domain().clone(), images)
    }
}

impl<P: Affine> BezierCurve<P> {
    /// The curve in the other direction, over the same domain: its control points are bₙ … b₀.
    ///
    /// ```text
    /// b̃(u) = b(a + b − u),   on [0, 1]:  b̃(t) = b(1 − t)
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::bezier::BezierCurve;
    ///
    /// let square = BezierCurve::new([0.0, 0.0, 1.0])?; // t²
    /// assert_eq!(square.reversed().at(0.25), 0.75 * 0.75);
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §4.3.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let points = self.control_points().iter().rev().cloned();
        Self::trusted(self.domain().clone(), points.collect())
    }
}
