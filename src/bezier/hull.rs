//! The convex hull of the control polygon.

use super::curve::BezierCurve;
use crate::affine::{ConvexHull, Orient, Point};

impl<T: Orient> BezierCurve<Point<T, 2>> {
    /// The convex hull of the control points, which contains the curve over its domain; O(n log n).
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// let hull = curve.convex_hull();
    /// assert_eq!(hull.vertices().len(), 4);
    /// assert!(hull.contains(&curve.at(0.25)));
    /// assert!(!hull.contains(&curve.at(1.5)), "outside the domain the curve may leave the hull");
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `farin2002`, §4.3.
    #[must_use]
    pub fn convex_hull(&self) -> ConvexHull<T> {
        ConvexHull::of(self.control_points())
            .expect("a curve has at least one control point, and all are finite")
    }
}
