//! Figures of the section on the shape of Bézier curves.

use crate::affine::{Affine, AffineMap, BoundingBox, ConvexHull, Line, Vector, plane_determinant};
use crate::bezier::{
    BezierCurve, LineIntersections, PlaneCurve, Root, RootKind, laws, sign_changes,
};
use crate::figure::{BoxError, Canvas, Figure, Place, PointStyle, Side, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![
        figure_affine_invariance(),
        figure_convex_hull(),
        line_intersections(),
        variation_diminishing(),
    ]
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
        let directions = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(Vector::from);
        canvas.law(
            "bezier-convex-hull",
            &laws::convex_hull(BezierCurve::at, &curve, 0.5, &directions),
        );
        match hull.vertices().len() {
            1 => canvas.remark("All control points are in one place: the hull is this point, and so is the curve."),
            2 => canvas.remark("The control points are on a line: the hull is a segment, and the curve stays on it."),
            _ => {}
        }
        Ok(())
    })
}

/// A cubic and its image under an affine map; the image of a point is the point of the image.
#[must_use]
pub fn figure_affine_invariance() -> Figure {
    Figure::new(
        "bezier-figure-affine-invariance",
        "A Bézier curve and its image under an affine map",
        "On the left a cubic Bézier curve with its control polygon and a point at the parameter t. \
         On the right, dashed, their images under an affine map: the control polygon is mapped, \
         and its Bézier curve goes through the images of the points of the first curve.",
    )
    .handles("b", [[0.0, 0.0], [0.5, 2.5], [3.0, 3.0], [3.5, 0.5]])
    .handle("a", [5.0, 0.0])
    .slider("m_11", -1.5..=1.5, 0.8)
    .slider("m_12", -1.5..=1.5, 0.6)
    .slider("m_21", -1.5..=1.5, -0.3)
    .slider("m_22", -1.5..=1.5, 1.1)
    .slider("t", 0.0..=1.0, 0.4)
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let row = |i: usize| -> Result<[f64; 2], crate::figure::FigureError> {
            Ok([
                values.number(&format!("m_{i}1"))?,
                values.number(&format!("m_{i}2"))?,
            ])
        };
        let translation = values.point("a")?;
        let map = AffineMap::new([row(1)?, row(2)?], [translation[0], translation[1]]);
        let image = curve.mapped(&map)?;
        let t = values.number("t")?;
        canvas.polyline("polygon", curve.control_points(), Style::ControlPolygon);
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.polyline(
            "image polygon",
            image.control_points(),
            Style::SecondPolygon,
        );
        canvas.curve("image", 0.0..=1.0, |t| image.at(t), Style::SecondCurve);
        canvas.point("b(t)", curve.at(t), PointStyle::OnCurve);
        canvas.point("image of b(t)", map.point(&curve.at(t)), PointStyle::Result);
        canvas.labels("b", curve.control_points());
        canvas.label("b(t)", curve.at(t));
        for (i, point) in image.control_points().iter().enumerate() {
            canvas.label(&format!("\\alpha(b_{i})"), point);
        }
        canvas.label("\\alpha(b(t))", map.point(&curve.at(t)));
        canvas.law(
            "bezier-affine-invariance",
            &laws::affine_invariance(|_, _| image.clone(), &curve, &map, t),
        );
        if plane_determinant(&Vector::from(row(1)?), &Vector::from(row(2)?)) == 0.0 {
            canvas.remark(
                "The determinant is 0: the map flattens the plane onto a line or a point. \
                 The statement does not ask for an inverse, and it holds.",
            );
        }
        Ok(())
    })
}

/// A cubic and a line through two points that can be dragged, with their intersections.
#[must_use]
pub fn line_intersections() -> Figure {
    Figure::new(
        "bezier-line-intersections",
        "A cubic meets a line at most three times",
        "A cubic Bézier curve in the shape of an S with its control polygon, and a line through two points. \
         The intersections are marked by crosses; here there are three, and never are there more.",
    )
    .handles("b", [[0.0, 0.5], [4.0, 6.0], [3.0, -4.0], [7.0, 2.0]])
    .handle("p", [0.3, 1.6])
    .handle("q", [6.6, 0.2])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let [p, q] = [values.point("p")?, values.point("q")?];
        canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        // Two points in one place have no line.
        if let Ok(line) = Line::through(&p, &q) {
            canvas.line("line", p, q, Style::Tangent);
            let meetings = curve.line_intersections(&line)?;
            let points = meetings.parameters().iter().map(|root| curve.at(root.parameter()));
            canvas.points("intersections", points, PointStyle::Cross);
            let found: Vec<(f64, usize)> = meetings
                .parameters()
                .iter()
                .map(|root| (root.parameter(), multiplicity(root.kind)))
                .collect();
            canvas.law(
                "bezier-line-intersections",
                &laws::line_intersections(|_, _| meetings.clone(), &curve, &line, &found),
            );
        }
        remark_on_line(canvas, &curve, &p, &q)?;
        canvas.points("points of the line", [p, q], PointStyle::Guide);
        canvas.labels("b", curve.control_points());
        canvas.label("p", p);
        canvas.label("q", q);
        Ok(())
    })
}

/// A curve of degree 5 crosses a line less often than its polygon.
#[must_use]
pub fn variation_diminishing() -> Figure {
    Figure::new(
        "bezier-variation-diminishing",
        "The curve crosses a line at most as often as its polygon",
        "A Bézier curve of degree 5 whose control polygon goes up and down, and a line through two points. \
         The line crosses the polygon five times, at the solid dots, and the curve three times, at the crosses. \
         A text gives both numbers.",
    )
    .handles(
        "b",
        [[0.0, 0.0], [1.0, 4.0], [2.8, -1.6], [4.2, 5.0], [6.0, -1.0], [7.0, 3.2]],
    )
    .handle("p", [-0.4, 1.0])
    .handle("q", [7.4, 2.0])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let [p, q] = [values.point("p")?, values.point("q")?];
        canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        // Two points in one place have no line.
        if let Ok(line) = Line::through(&p, &q) {
            canvas.line("line", p, q, Style::Tangent);
            let meetings = curve.line_intersections(&line)?;
            let crossings: Vec<_> = meetings.parameters().iter().filter(|root| crosses(root)).collect();
            let on_curve = crossings.iter().map(|root| curve.at(root.parameter()));
            canvas.points("crossings of the curve", on_curve, PointStyle::Cross);
            canvas.points("crossings of the polygon", on_legs(&curve, &line)?, PointStyle::Level(1));
            let function = curve.hyperplane_function(&line)?;
            let numbers = format!(
                "crossings of the polygon: {}\ncrossings of the curve: {}",
                sign_changes(function.control_points()),
                crossings.len()
            );
            canvas.text("crossings", &numbers, [-0.4, 4.9], Side::Right);
            let parameters: Vec<f64> = (0..=64).map(|k| f64::from(k) / 64.0).collect();
            canvas.law(
                "bezier-variation-diminishing",
                &laws::variation_diminishing(BezierCurve::at, &curve, &line, &parameters),
            );
        }
        remark_on_line(canvas, &curve, &p, &q)?;
        canvas.points("points of the line", [p, q], PointStyle::Guide);
        canvas.labels("b", curve.control_points());
        canvas.label("p", p);
        canvas.label("q", q);
        Ok(())
    })
}

/// How many intersections a root certainly stands for.
fn multiplicity(kind: RootKind) -> usize {
    match kind {
        RootKind::Exactly(multiplicity) => multiplicity,
        RootKind::Odd => 1,
        RootKind::Possible => 0,
    }
}

/// What becomes of the intersections where there is no line, or the curve lies in it.
fn remark_on_line(
    canvas: &mut Canvas,
    curve: &PlaneCurve,
    p: &Place,
    q: &Place,
) -> Result<(), BoxError> {
    match Line::through(p, q) {
        Err(_) => canvas.remark("p and q are in one place, and no line is determined by them."),
        Ok(line) => {
            if curve.line_intersections(&line)? == LineIntersections::Within {
                canvas.remark(
                    "The whole curve lies in the line, and each of its points is an intersection. \
                     That there are at most n needs a curve that is not in the line.",
                );
            }
        }
    }
    Ok(())
}

/// Whether the sign changes at a root inside the unit interval.
fn crosses(root: &Root<f64>) -> bool {
    let odd = match root.kind {
        RootKind::Exactly(multiplicity) => multiplicity % 2 == 1,
        RootKind::Odd => true,
        RootKind::Possible => false,
    };
    odd && 0.0 < root.high && root.low < 1.0
}

/// Where the legs of the control polygon cross a line between their ends.
fn on_legs(
    curve: &PlaneCurve,
    line: &Line<f64>,
) -> Result<Vec<crate::affine::Point<f64, 2>>, crate::bezier::BezierError> {
    let function = curve.hyperplane_function(line)?;
    let legs = std::iter::zip(
        function.control_points().windows(2),
        curve.control_points().windows(2),
    );
    Ok(legs
        .filter(|(values, _)| values[0].min(values[1]) < 0.0 && values[0].max(values[1]) > 0.0)
        .map(|(values, ends)| ends[0].lerp(&ends[1], values[0] / (values[0] - values[1])))
        .collect())
}
