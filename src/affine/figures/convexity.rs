//! Figures of the section on convexity.

use crate::affine::{Affine, Point, SimplePolygon};
use crate::figure::{BoxError, Canvas, Figure, PointStyle, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_convex()]
}

type Place = Point<f64, 2>;

/// How many vertices a blob has.
const VERTICES: usize = 72;

/// A convex and a non-convex blob, each with a segment between two points that can be dragged.
#[must_use]
pub fn figure_convex() -> Figure {
    Figure::new(
        "affine-figure-convex",
        "A convex set and one that is not convex",
        "On the left an ellipse with a segment between two of its points, which stays inside. \
         On the right a bent ellipse with a segment between two of its points; its middle part, dashed, lies outside the set.",
    )
    .handles_in("convex", "p", [[-1.4, 0.5], [1.5, -0.4]])
    .handles_in("not convex", "q", [[-1.5, 0.3], [1.5, 0.6]])
    .draw(|values, canvas| {
        canvas.panel("convex");
        canvas.caption("convex");
        set_with_segment(canvas, &blob(0.0)?, "p", &values.points("p")?);
        canvas.panel("not convex");
        canvas.caption("not convex");
        set_with_segment(canvas, &blob(0.6)?, "q", &values.points("q")?);
        Ok(())
    })
}

/// A polygon along an ellipse that is bent upwards: (x, y) becomes (x, y + bend·x²).
fn blob(bend: f64) -> Result<SimplePolygon<f64>, BoxError> {
    let vertex = |k: usize| {
        let angle = k as f64 / VERTICES as f64 * std::f64::consts::TAU;
        let (x, y) = (2.0 * libm::cos(angle), libm::sin(angle));
        Point::new([x, y + bend * (x * x - 2.0)])
    };
    Ok(SimplePolygon::new((0..VERTICES).map(vertex))?)
}

/// A set and the segment between two points; its parts outside the set are drawn over it.
fn set_with_segment(canvas: &mut Canvas, set: &SimplePolygon<f64>, name: &str, ends: &[Place]) {
    canvas.window([-2.2, -1.9], [2.2, 1.9]);
    canvas.polygon("set", set.vertices(), Style::Region);
    canvas.polygon("outline", set.vertices(), Style::Connector);
    let [start, end] = [ends[0], ends[1]];
    canvas.segment("segment", start, end, Style::Connector);
    let mut reached = 0.0;
    for (i, part) in set.parts_outside(&start, &end).iter().enumerate() {
        let [from, to] = [part.start(), part.end()].map(|t| start.lerp(&end, t));
        canvas.segment(
            &format!("inside {i}"),
            start.lerp(&end, reached),
            from,
            Style::Curve,
        );
        canvas.segment(&format!("outside {i}"), from, to, Style::SecondCurve);
        reached = part.end();
    }
    canvas.segment("inside", start.lerp(&end, reached), end, Style::Curve);
    canvas.points("ends", ends, PointStyle::Control);
    canvas.labels(name, ends);
}
