//! Boxes around Bézier curves.

use super::curve::BezierCurve;
use crate::affine::{Affine, BoundingBox};
use crate::scalar::OrderedScalar;

impl<P: Affine> BezierCurve<P>
where
    P::Scalar: OrderedScalar,
{
    /// The box of the control points, which contains the curve over its domain; in O(n) comparisons.
    ///
    /// ```text
    /// minᵢ bᵢ,ₖ ≤ bₖ(u) ≤ maxᵢ bᵢ,ₖ   for every coordinate k and a ≤ u ≤ b
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let bounds = curve.bounding_box();
    /// assert_eq!(bounds.high(), &Point::new([4.0, 4.0]));
    /// assert!(bounds.contains(&curve.at(0.3)));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `class-notes`, section 4.
    #[must_use]
    pub fn bounding_box(&self) -> BoundingBox<P> {
        let points = self.control_points();
        BoundingBox::around(&points[0], &points[1..])
    }
}
