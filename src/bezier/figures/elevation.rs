//! Figures of the section on degree elevation and Bernstein approximation.

use crate::bezier::{BezierCurve, laws};
use crate::figure::{Axes, Figure, Side, Style};
use crate::scalar::OrderedScalar;

pub(super) fn all() -> Vec<Figure> {
    vec![
        degree_elevation(),
        bernstein_approximation(),
        disadvantages(),
    ]
}

/// The numbers of elevations that are drawn, and the line style of each polygon.
const ELEVATIONS: [(usize, Style); 5] = [
    (0, Style::ControlPolygon),
    (1, Style::Series(1)),
    (2, Style::Series(2)),
    (5, Style::Series(3)),
    (20, Style::Series(4)),
];

/// The control polygons of one cubic after 0, 1, 2, 5 and 20 elevations.
#[must_use]
pub fn degree_elevation() -> Figure {
    Figure::new(
        "bezier-degree-elevation",
        "Elevated control polygons approach the curve",
        "A cubic Bézier curve and its control polygons after 0, 1, 2, 5 and 20 degree elevations. \
         Each polygon cuts the corners of the one before and lies closer to the curve; \
         the ends stay.",
    )
    .handles("b", [[0.0, 0.0], [1.0, 5.0], [7.0, 5.0], [8.0, 1.0]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        for (times, style) in ELEVATIONS {
            let elevated = curve.elevated_times(times);
            let name = format!("{times} elevations");
            canvas.polyline(&name, elevated.control_points(), style);
            canvas.legend(&format!("$r = {times}$"), style);
        }
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.labels("b", curve.control_points());
        canvas.law(
            "bezier-degree-elevation",
            &laws::degree_elevation(BezierCurve::elevated, &curve, 0.5),
        );
        if curve
            .control_points()
            .windows(2)
            .all(|leg| leg[0] == leg[1])
        {
            canvas.remark(
                "All control points are in one place, and elevation adds more of them there.",
            );
        }
        Ok(())
    })
}

/// The corner of |t − 1/2| and its Bernstein approximations.
#[must_use]
pub fn bernstein_approximation() -> Figure {
    Figure::new(
        "bezier-bernstein-approximation",
        "Bernstein approximations of a corner",
        "The graph of the absolute value of t minus one half on the interval from 0 to 1, \
         and its Bernstein approximations of degree 2, 8 and 32 and of a degree that can be chosen. \
         They lie above the graph, come closer with the degree, and round off the corner.",
    )
    .stepper("m", 1..=64, 4)
    .draw(|values, canvas| {
        let corner = |t: f64| OrderedScalar::abs(&(t - 0.5));
        canvas.axes(Axes::new("t", "F"));
        canvas.free_aspect(0.62);
        canvas.graph("F", 0.0..=1.0, corner, Style::Guide);
        canvas.legend("$F$", Style::Guide);
        for (k, m) in [2, 8, 32].into_iter().enumerate() {
            let approximation = BezierCurve::bernstein_approximation(corner, m)?;
            let name = format!("degree {m}");
            canvas.graph(&name, 0.0..=1.0, |t| approximation.at(t), Style::Series(k + 1));
            canvas.legend(&format!("$m = {m}$"), Style::Series(k + 1));
        }
        let chosen = BezierCurve::bernstein_approximation(corner, values.count("m")?)?;
        canvas.graph("chosen degree", 0.0..=1.0, |t| chosen.at(t), Style::Curve);
        canvas.legend(&format!("$m = {}$ (chosen)", values.count("m")?), Style::Curve);
        let law = laws::bernstein_approximation(
            |polygon: &dyn Fn(f64) -> f64, m| {
                BezierCurve::bernstein_approximation(polygon, m).unwrap_or_else(|_| chosen.clone())
            },
            chosen.control_points(),
            0.5,
        );
        canvas.law("bezier-bernstein-approximation", &law);
        if chosen.degree() == 1 {
            canvas.remark("For m = 1 only the ends count: the approximation is the chord, and the corner does not show at all.");
        }
        Ok(())
    })
}

/// A curve of degree 9 far from its control points, and what moving one of them does.
#[must_use]
pub fn disadvantages() -> Figure {
    Figure::new(
        "bezier-disadvantages",
        "A single control point moves the whole curve",
        "A Bézier curve of degree 9 whose control polygon zigzags far away from it. \
         One control point is moved to a second place; \
         the curve of the changed polygon, drawn as well, differs everywhere but at the ends.",
    )
    .handles(
        "b",
        [
            [0.0, 0.0],
            [1.0, 3.5],
            [2.5, -3.0],
            [4.0, 4.0],
            [5.5, -3.0],
            [7.0, 4.0],
            [8.5, -3.0],
            [10.0, 4.0],
            [11.5, -2.0],
            [13.0, 1.0],
        ],
    )
    .handle("c", [8.0, 6.5])
    .draw(|values, canvas| {
        let points = values.points("b")?;
        let moved_to = values.point("c")?;
        let mut moved = points.clone();
        moved[MOVED] = moved_to;
        let curve = BezierCurve::new(points)?;
        let changed = BezierCurve::new(moved)?;
        canvas.polyline(
            "changed polygon",
            &changed.control_points()[MOVED - 1..=MOVED + 1],
            Style::SecondPolygon,
        );
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        canvas.curve(
            "changed curve",
            0.0..=1.0,
            |t| changed.at(t),
            Style::SecondCurve,
        );
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.arrow(
            "move",
            curve.control_points()[MOVED],
            moved_to,
            Style::Tangent,
        );
        canvas.label_on(Side::Right, "c", moved_to);
        canvas.label("b_0", curve.control_points()[0]);
        canvas.label(&format!("b_{MOVED}"), curve.control_points()[MOVED]);
        canvas.label("b_9", curve.control_points()[9]);
        if curve.control_points() == changed.control_points() {
            canvas.remark("The control point is where it was, and both curves are the same.");
        }
        Ok(())
    })
}

/// Which control point is moved.
const MOVED: usize = 5;
