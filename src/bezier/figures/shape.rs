//! Figures of the section on the shape of Bézier curves.

use crate::affine::{BoundingBox, ConvexHull};
use crate::bezier::BezierCurve;
use crate::figure::{Figure, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_convex_hull()]
}

/// A quartic in the convex hull of its control points, and in their bounding box.
#[must_use]
pub fn figure_convex_hull() -> Figure {
    Figure::new(
        "bezier-figure-convex-hull",
        "A Bézier curve lies in the convex hull of its control points",
        "A Bézier curve of degree 4 with its control polygon. \
         The convex hull of the five control points is shaded and contains the curve; \
         one control point lies inside the hull. \
         The bounding box of the control points, dotted, contains the hull.",
    )
    .handles(
        "b",
        [[0.4, 1.0], [0.0, 4.2], [4.6, 1.4], [5.6, 4.8], [8.0, 0.0]],
    )
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let hull = ConvexHull::of(curve.control_points())?;
        let bounds = BoundingBox::of(curve.control_points())?;
        canvas.polygon("hull", hull.vertices(), Style::Region);
        canvas.rectangle("box", bounds.low(), bounds.high(), Style::Bound);
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.labels("b", curve.control_points());
        Ok(())
    })
}
