//! Figures of the section on subdivision.

use crate::affine::Point;
use crate::bezier::{BezierCurve, PlaneCurve, laws};
use crate::figure::{Canvas, Figure, PointStyle, Style, decimal, midpoint};

pub(super) fn all() -> Vec<Figure> {
    vec![
        figure_subdivision(),
        figure_corner_cutting(),
        corner_cutting_convergence(),
    ]
}

/// A cubic cut at α: both control polygons are sides of the scheme of de Casteljau.
#[must_use]
pub fn figure_subdivision() -> Figure {
    Figure::new(
        "bezier-figure-subdivision",
        "A Bézier curve divided at b(α)",
        "A cubic Bézier curve and the segments of its de Casteljau construction at a parameter alpha. \
         The first points of all levels form the control polygon of the left piece, drawn with round vertices; \
         the last points form that of the right piece, drawn with square vertices. \
         Both polygons meet in the curve point b(alpha).",
    )
    .handles("b", [[0.0, 0.0], [1.0, 4.0], [6.0, 5.0], [8.0, 0.5]])
    .slider("alpha", 0.0..=1.0, 0.4)
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let alpha = values.number("alpha")?;
        let triangle = curve.triangle(alpha);
        let [left, right] = curve.subdivided(alpha)?;
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        for level in 1..curve.degree() {
            canvas.polyline(
                &format!("segments of level {level}"),
                triangle.column(level),
                Style::Guide,
            );
        }
        canvas.curve("left piece", 0.0..=1.0, |t| left.at(t), Style::Curve);
        canvas.curve("right piece", 0.0..=1.0, |t| right.at(t), Style::SecondCurve);
        canvas.polyline("left polygon", left.control_points(), Style::Level(1));
        canvas.polyline("right polygon", right.control_points(), Style::Level(2));
        canvas.point("b(alpha)", triangle.tip(), PointStyle::Result);
        canvas.label("b(\\alpha)", triangle.tip());
        canvas.labels("b", curve.control_points());
        canvas.label("b_0^1", triangle.point(1, 0));
        canvas.label("b_2^1", triangle.point(1, 2));
        canvas.legend("left piece", Style::Level(1));
        canvas.legend("right piece", Style::Level(2));
        let pieces = [left, right];
        canvas.law(
            "bezier-subdivision",
            &laws::subdivision(|_, _| pieces.clone(), &curve, alpha, 0.5),
        );
        if alpha == 0.0 || alpha == 1.0 {
            canvas.remark(
                "α is an end of the interval: one piece is a point, and the other is the whole curve. \
                 Two pieces with a polygon of their own need 0 < α < 1.",
            );
        }
        Ok(())
    })
}

/// The scheme of a cubic at 1/2 with the lengths of the new legs.
#[must_use]
pub fn figure_corner_cutting() -> Figure {
    Figure::new(
        "bezier-figure-corner-cutting",
        "New legs are at most half as long as the longest old one",
        "The de Casteljau construction of a cubic at one half. \
         The six legs of the two new control polygons are labelled with their lengths as multiples of d, \
         the length of the longest leg of the control polygon; none is above 0.5.",
    )
    .handles("b", [[0.0, 0.0], [1.5, 5.0], [8.0, 6.0], [10.0, 0.5]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let triangle = curve.triangle(0.5);
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        for level in 1..curve.degree() {
            canvas.polyline(
                &format!("segments of level {level}"),
                triangle.column(level),
                Style::Guide,
            );
        }
        let longest = curve
            .control_points()
            .windows(2)
            .map(|leg| (leg[1] - leg[0]).norm())
            .fold(0.0, f64::max);
        let [left, right] = curve.halves();
        for (name, half, style) in [
            ("left polygon", left, Style::Level(1)),
            ("right polygon", right, Style::Level(2)),
        ] {
            for leg in half.control_points().windows(2) {
                // With all points at one place every leg is 0 of everything.
                let share = (leg[1] - leg[0]).norm() / longest.max(f64::MIN_POSITIVE);
                canvas.label(&format!("{} d", decimal(share, 2)), midpoint(leg[0], leg[1]));
            }
            canvas.polyline(name, half.control_points(), style);
        }
        canvas.point("b(1/2)", triangle.tip(), PointStyle::OnCurve);
        canvas.labels("b", curve.control_points());
        canvas.law(
            "bezier-corner-cutting-convergence",
            &laws::corner_cutting_convergence(vertices, &curve, 1),
        );
        remark_on_point(canvas, longest == 0.0);
        Ok(())
    })
}

/// The control polygon after some halvings.
fn vertices(curve: &PlaneCurve, steps: usize) -> Vec<Point<f64, 2>> {
    let polygon = curve.corner_cutting().nth(steps);
    polygon.map_or_else(Vec::new, |polygon| polygon.vertices().to_vec())
}

/// What is left of the legs where all control points are in one place.
fn remark_on_point(canvas: &mut Canvas, is_point: bool) {
    if is_point {
        canvas.remark(
            "All control points are in one place: every leg has the length 0, before and after.",
        );
    }
}

/// The steps that are drawn, one panel each.
const STEPS: [&str; 4] = ["k = 0", "k = 1", "k = 2", "k = 3"];

/// The control polygon after 0, 1, 2 and 3 steps of corner cutting.
#[must_use]
pub fn corner_cutting_convergence() -> Figure {
    Figure::new(
        "bezier-corner-cutting-convergence",
        "Corner cutting converges to the curve",
        "Four panels show a cubic Bézier curve with the control polygons of all its pieces after 0, 1, 2 and 3 halvings. \
         In each step corners are cut off, and after three steps polygon and curve can hardly be told apart.",
    )
    .handles_in("k = 0", "b", [[0.0, 0.0], [1.0, 6.0], [7.0, 6.5], [8.0, 1.0]])
    .rows(&[&["k = 0", "k = 1"], &["k = 2", "k = 3"]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        for (panel, polygon) in std::iter::zip(STEPS, curve.corner_cutting()) {
            canvas.panel(panel);
            canvas.caption(&format!("$P_{}$", polygon.step()));
            canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
            canvas.polyline("polygon", polygon.vertices(), Style::SecondPolygon);
        }
        canvas.law(
            "bezier-corner-cutting-convergence",
            &laws::corner_cutting_convergence(vertices, &curve, 3),
        );
        let points = curve.control_points();
        remark_on_point(canvas, points.windows(2).all(|leg| leg[0] == leg[1]));
        Ok(())
    })
}
