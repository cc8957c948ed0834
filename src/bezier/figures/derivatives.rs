//! Figures of the section on derivatives.

use crate::affine::Point;
use crate::bezier::{BezierCurve, ParabolaMap, QuadraticTrace, laws};
use crate::curves::PlaneCurvature;
use crate::figure::{Canvas, Figure, PointStyle, Side, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![
        derivative_consequences(),
        de_casteljau_worked_example(),
        end_curvature(),
        quadratic_parabola(),
    ]
}

/// The last segment of the construction is the tangent; the hodograph in a second panel.
#[must_use]
pub fn derivative_consequences() -> Figure {
    Figure::new(
        "bezier-derivative-consequences",
        "The tangent of a Bézier curve and its hodograph",
        "First panel: a cubic Bézier curve, its control polygon and the construction of de Casteljau at t. \
         The last segment of the construction touches the curve at b(t). \
         Second panel: the hodograph, a parabola whose control vectors are three times the legs of the control polygon. \
         An arrow from the origin to the hodograph is the derivative at t; it is parallel to the last segment.",
    )
    .slider("t", 0.0..=1.0, 0.4)
    .handles_in("curve", "b", [[0.0, 0.0], [1.0, 3.0], [4.4, 3.6], [5.4, 0.4]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let t = values.number("t")?;
        let triangle = curve.triangle(t);
        let last = triangle.column(curve.degree() - 1);
        canvas.panel("curve");
        canvas.caption("the curve $b$");
        canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
        canvas.polyline("level 1", triangle.column(1), Style::Level(1));
        canvas.curve("curve", 0.0..=1.0, |s| curve.at(s), Style::Curve);
        canvas.segment("last segment", last[0], last[1], Style::Tangent);
        canvas.points("level 2", last, PointStyle::Level(2));
        canvas.point("b(t)", triangle.tip(), PointStyle::Result);
        canvas.labels("b", curve.control_points());
        canvas.label_on(Side::BelowRight, "b(t)", triangle.tip());

        let hodograph = curve.derivative();
        let value = hodograph.at(t);
        canvas.panel("hodograph");
        canvas.caption("its hodograph $b'$");
        canvas.polyline("control vectors", hodograph.control_points(), Style::SecondPolygon);
        canvas.curve("hodograph", 0.0..=1.0, |s| hodograph.at(s), Style::SecondCurve);
        canvas.arrow("b'(t)", [0.0, 0.0], value, Style::Tangent);
        canvas.point("origin", [0.0, 0.0], PointStyle::Guide);
        canvas.label("0", [0.0, 0.0]);
        canvas.label("b'(t)", value);
        for (i, vector) in hodograph.control_points().iter().enumerate() {
            canvas.label(&format!("3\\Delta b_{i}"), vector);
        }
        canvas.panel("curve");
        canvas.law(
            "bezier-derivative-consequences",
            &laws::derivative_consequences(BezierCurve::derivative, &curve, t),
        );
        remark_on_tangent(canvas, last);
        Ok(())
    })
}

/// What becomes of the tangent where the derivative is 0.
fn remark_on_tangent(canvas: &mut Canvas, last_segment: &[Point<f64, 2>]) {
    if last_segment.windows(2).all(|ends| ends[0] == ends[1]) {
        canvas.remark(
            "The last segment is a point: the derivative is 0 here, and the construction shows no tangent. \
             That the segment is tangent needs b′(t) ≠ 0.",
        );
    }
}

/// The construction of the worked example at t = 0.6, with the tangent.
#[must_use]
pub fn de_casteljau_worked_example() -> Figure {
    Figure::new(
        "bezier-de-casteljau-worked-example",
        "The construction of the worked example",
        "A cubic Bézier curve with the control points (0, 0), (2, 4.5), (8.5, 6.5) and (11, 2). \
         The construction of de Casteljau at t = 0.6 has three points on the first level, two on the second and one on the curve. \
         The line through the two points of the second level is the tangent there; it is nearly horizontal.",
    )
    .slider("t", 0.0..=1.0, 0.6)
    .handles("b", [[0.0, 0.0], [2.0, 4.5], [8.5, 6.5], [11.0, 2.0]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let triangle = curve.triangle(values.number("t")?);
        let last = triangle.column(2);
        canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
        canvas.polyline("level 1", triangle.column(1), Style::Level(1));
        canvas.curve("curve", 0.0..=1.0, |s| curve.at(s), Style::Curve);
        if last[0] != last[1] {
            canvas.line("tangent", last[0], last[1], Style::Guide);
        }
        canvas.polyline("level 2", last, Style::Level(2));
        canvas.point("b(t)", triangle.tip(), PointStyle::Result);
        for (level, column) in triangle.columns().enumerate() {
            for (i, point) in column.iter().enumerate() {
                match level {
                    0 => canvas.label(&format!("b_{i}"), point),
                    _ => canvas.label(&format!("b_{i}^{level}"), point),
                }
            }
        }
        canvas.law(
            "bezier-de-casteljau",
            &laws::de_casteljau(BezierCurve::triangle, &curve, values.number("t")?),
        );
        remark_on_tangent(canvas, last);
        Ok(())
    })
}

/// The osculating circle at the start depends on three control points only.
#[must_use]
pub fn end_curvature() -> Figure {
    Figure::new(
        "bezier-end-curvature",
        "The curvature at the first control point",
        "A cubic Bézier curve with its control polygon and the osculating circle at its first control point. \
         The circle touches the first leg there and follows the curve closely. \
         A segment joins its centre m to the first control point. \
         The circle depends on the first three control points: moving the last one leaves it unchanged.",
    )
    .handles("b", [[0.0, 0.0], [2.0, 0.0], [3.6, 1.2], [4.0, 4.0]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let start = curve.control_points()[0];
        canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
        // Without a circle the curve is straight or singular there, and there is nothing to add.
        if let Ok(circle) = curve.osculating_circle(0.0) {
            canvas.circle("osculating circle", circle.centre(), circle.radius(), Style::Tangent);
            canvas.segment("radius", circle.centre(), start, Style::Guide);
            canvas.point("centre", circle.centre(), PointStyle::Result);
            canvas.label("m", circle.centre());
        }
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.labels("b", curve.control_points());
        let points = curve.control_points();
        if points[0] == points[1] {
            canvas.remark(
                "b₀ and b₁ are in one place: the derivative is 0 there, and the formula divides by the length of the first leg. \
                 It needs b₀ ≠ b₁.",
            );
            return Ok(());
        }
        if curve.osculating_circle(0.0).is_err() {
            canvas.remark("b₀, b₁ and b₂ are on a line: the curvature at the start is 0, and there is no circle.");
        }
        canvas.law(
            "bezier-end-curvature",
            &laws::end_curvature(
                |curve, t| {
                    let curvature = PlaneCurvature::curvature(curve, t).ok()?;
                    Some(curvature * curvature.abs())
                },
                &curve,
            ),
        );
        Ok(())
    })
}

/// An arc of a parabola over its control triangle, with the axis; collinear points give a segment.
#[must_use]
pub fn quadratic_parabola() -> Figure {
    Figure::new(
        "bezier-quadratic-parabola",
        "A quadratic Bézier curve is an arc of a parabola",
        "A quadratic Bézier curve over its control triangle. \
         Dashed, the same parabola goes on beyond both ends. \
         An arrow from the middle control point to the middle of the chord has the direction of the axis, \
         and the axis itself runs through the vertex of the parabola in this direction. \
         If the three control points are moved onto a line, a segment remains, and a mark where the curve turns back.",
    )
    .handles("b", [[0.0, 2.0], [1.6, -2.4], [6.4, 2.0]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let points = curve.control_points();
        let map = ParabolaMap::of(&curve)?;
        canvas.polyline("control polygon", points, Style::ControlPolygon);
        match curve.quadratic_trace()? {
            QuadraticTrace::Parabola => {
                canvas.curve("before", -0.5..=0.0, |t| curve.at(t), Style::Extension);
                canvas.curve("after", 1.0..=1.4, |t| curve.at(t), Style::Extension);
                if let Some(vertex) = map.vertex_parameter().map(|t| curve.at(t)) {
                    canvas.line("axis", vertex, vertex + *map.axis(), Style::Guide);
                    canvas.point("vertex", vertex, PointStyle::Result);
                    canvas.label("vertex", vertex);
                }
                let half = *map.axis() * 0.5;
                canvas.arrow("half axis direction", points[1], points[1] + half, Style::Tangent);
                canvas.label_on(Side::Above, "1/2(b_2-2b_1+b_0)", points[1] + half);
            }
            QuadraticTrace::Turning { at } => {
                canvas.point("turning point", curve.at(at), PointStyle::Result);
                canvas.label("turns back", curve.at(at));
            }
            QuadraticTrace::Segment | QuadraticTrace::Point => {}
        }
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.labels("b", points);
        canvas.law(
            "bezier-quadratic-parabola",
            &laws::quadratic_parabola(|_, x, y| map.apply(x, y), &curve, 0.5),
        );
        match curve.quadratic_trace()? {
            QuadraticTrace::Parabola => {}
            QuadraticTrace::Turning { .. } => canvas.remark(
                "The control points are on a line: the map flattens the parabola onto it, \
                 and the curve runs to and fro. For an arc of a parabola the three points must not be on a line.",
            ),
            QuadraticTrace::Segment => canvas.remark(
                "The control points are on a line in their order: the map flattens the parabola onto it, \
                 and a segment remains.",
            ),
            QuadraticTrace::Point => canvas.remark("The control points are in one place, and so is the curve."),
        }
        Ok(())
    })
}
