//! Boxes around Bézier curves.

use super::curve::{BezierCurve, BezierError};
use super::roots::{RootSearch, largest};
use crate::affine::{Affine, BoundingBox, Interval, Point};
use crate::scalar::{OrderedScalar, UNIT_ROUNDOFF};

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

impl<const D: usize> BezierCurve<Point<f64, D>> {
    /// The smallest box around the curve itself, up to rounding.
    ///
    /// In each coordinate the curve is monotone between two roots of its derivative.
    /// So its extreme values are at the ends of the domain or in the small intervals that hold the roots.
    /// There the control values of the piece bound it, which is safe if a root is multiple.
    /// Each side is off by at most γ₃ₙ·max|bᵢ| outside, and inside only by what the curve varies in
    /// an interval of a root.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// assert_eq!(curve.tight_bounding_box().high(), &Point::new([4.0, 3.0]));
    /// assert_eq!(curve.bounding_box().high(), &Point::new([4.0, 4.0]));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    #[must_use]
    pub fn tight_bounding_box(&self) -> BoundingBox<Point<f64, D>> {
        let points = self.control_points();
        let ranges: [BoundingBox<f64>; D] = std::array::from_fn(|k| {
            let values = points.iter().map(|point| point[k]).collect();
            range(&BezierCurve::trusted(Interval::unit(), values))
        });
        let low = Point::new(std::array::from_fn(|k| *ranges[k].low()));
        let high = Point::new(std::array::from_fn(|k| *ranges[k].high()));
        BoundingBox::around(&low, &[high])
    }
}

/// The interval of the values of a polynomial over [0, 1].
fn range(polynomial: &BezierCurve<f64>) -> BoundingBox<f64> {
    let values = polynomial.control_points();
    let ends = [values[0], values[polynomial.degree()]];
    // Differences can overflow where values do not; a quarter of the polynomial has the same roots.
    let differences: Vec<f64> = values
        .windows(2)
        .map(|pair| 0.25 * pair[1] - 0.25 * pair[0])
        .collect();
    if differences.is_empty() {
        return BoundingBox::around(&ends[0], &[]);
    }
    let derivative = BezierCurve::trusted(Interval::unit(), differences);
    let search = RootSearch {
        coefficient_error: UNIT_ROUNDOFF * 0.5 * largest(values) + f64::MIN_POSITIVE,
        ..RootSearch::default()
    };
    let roots = search.run(&derivative);
    let extremes = roots.isolated().iter().flat_map(|root| {
        let piece = Interval::new(root.low, root.high)
            .map_err(BezierError::from)
            .and_then(|domain| polynomial.restricted(domain));
        match piece {
            Ok(piece) => piece.control_points().to_vec(),
            Err(_) => vec![polynomial.at(root.low)],
        }
    });
    let all: Vec<f64> = extremes.chain(ends).collect();
    BoundingBox::around(&all[0], &all[1..])
}
