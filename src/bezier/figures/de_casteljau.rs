//! Figures of the section on the algorithm of de Casteljau.

use crate::affine::Point;
use crate::bezier::{BezierCurve, laws};
use crate::figure::{Canvas, Figure, PointStyle, Scheme, Style, decimal};

pub(super) fn all() -> Vec<Figure> {
    vec![
        motivation(),
        figure_de_casteljau(),
        parameter_range(),
        de_casteljau_triangle(),
    ]
}

/// The same cubic with its monomial coefficients and with its control polygon.
#[must_use]
pub fn motivation() -> Figure {
    const PANELS: [&str; 2] = ["monomials", "control points"];
    Figure::new(
        "bezier-motivation",
        "One cubic, two sets of coefficients",
        "The same cubic curve twice. \
         On the left its monomial coefficients: the point where it starts, and three vectors drawn from there as arrows, \
         of which only the first, the velocity at the start, has to do with the picture of the curve. \
         On the right its control polygon, which outlines the curve from one end to the other.",
    )
    .rows(&[&PANELS])
    .handles_in(
        PANELS[1],
        "b",
        [[0.0, 0.0], [1.0, 1.6], [3.0, 2.4], [6.4, 0.4]],
    )
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        for panel in PANELS {
            canvas.panel(panel);
            canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        }
        canvas.panel(PANELS[0]);
        canvas.caption("monomial coefficients");
        let start = curve.at(0.0);
        // The coefficient of t^k is the k-th derivative at 0, divided by k!.
        let derivatives = curve.derivatives::<3>(0.0);
        for ((k, derivative), factorial) in (1..).zip(derivatives).zip([1.0, 2.0, 6.0]) {
            let tip = start + derivative / factorial;
            canvas.arrow(&format!("a_{k}"), start, tip, Style::Tangent);
            canvas.label(&format!("a_{k}"), tip);
        }
        canvas.point("a_0", start, PointStyle::OnCurve);
        canvas.label("a_0", start);
        canvas.panel(PANELS[1]);
        canvas.caption("control points");
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        canvas.labels("b", curve.control_points());
        if curve.control_points().windows(2).all(|leg| leg[0] == leg[1]) {
            canvas.remark("All control points are in one place: the curve is this point, and the three vectors are 0.");
        }
        Ok(())
    })
}

/// The construction for n = 2, 3, 4: control polygon, intermediate segments, and the point b(t).
#[must_use]
pub fn figure_de_casteljau() -> Figure {
    const PANELS: [&str; 3] = ["n = 2", "n = 3", "n = 4"];
    Figure::new(
        "bezier-figure-de-casteljau",
        "The algorithm of de Casteljau for n = 2, 3, 4",
        "Three Bézier curves of degree 2, 3 and 4 with their control polygons. \
         Every segment of a polygon is divided in the ratio t to 1 − t; \
         the points of division are joined to a polygon with one segment fewer, in another colour for each level. \
         The last point of division lies on the curve, and the last segment touches the curve there.",
    )
    .rows(&[&PANELS[..2], &PANELS[2..]])
    .slider("t", 0.0..=1.0, 0.4)
    .handles_in(PANELS[0], "a", [[0.0, 0.0], [1.2, 3.0], [4.0, 0.6]])
    .handles_in(PANELS[1], "b", [[0.0, 0.0], [0.4, 3.0], [3.4, 3.4], [4.0, 0.4]])
    .handles_in(PANELS[2], "c", [[0.0, 0.2], [0.6, 3.8], [4.4, 5.0], [8.6, 3.4], [7.4, 0.0]])
    .draw(|values, canvas| {
        let t = values.number("t")?;
        for (panel, name) in PANELS.into_iter().zip(["a", "b", "c"]) {
            let curve = BezierCurve::new(values.points(name)?)?;
            let triangle = curve.triangle(t);
            let n = curve.degree();
            canvas.panel(panel);
            canvas.caption(&format!("n = {n}"));
            canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
            canvas.polyline("control polygon", curve.control_points(), Style::ControlPolygon);
            for level in 1..n {
                canvas.polyline(&format!("level {level}"), triangle.column(level), Style::Level(level));
            }
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
                "bezier-bernstein-representation",
                &laws::bernstein_representation(BezierCurve::at, &curve, t),
            );
        }
        remark_on_ends(canvas, t);
        Ok(())
    })
}

/// What the construction does at the ends of the interval.
fn remark_on_ends(canvas: &mut Canvas, t: f64) {
    if t == 0.0 {
        canvas.remark("t = 0: every point of division is the first end of its segment, and the last one is the first control point.");
    } else if t == 1.0 {
        canvas.remark("t = 1: every point of division is the second end of its segment, and the last one is the last control point.");
    }
}

/// A cubic beyond both ends of [0, 1], with the extrapolating construction.
#[must_use]
pub fn parameter_range() -> Figure {
    Figure::new(
        "bezier-parameter-range",
        "The curve beyond its parameter interval",
        "A cubic Bézier curve, solid for t in [0, 1] and dashed for t from −0.3 to 0 and from 1 to 1.3. \
         For the marked t outside [0, 1] every point of the construction lies on the prolongation of a segment, \
         which is drawn as a thin dashed line; the last of them lies on the dashed part of the curve.",
    )
    .slider("t", -0.3..=1.3, 1.2)
    .handles("b", [[0.0, 0.0], [0.6, 3.6], [4.6, 4.0], [7.5, 1.6]])
    .draw(|values, canvas| {
        let t = values.number("t")?;
        let curve = BezierCurve::new(values.points("b")?)?;
        let triangle = curve.triangle(t);
        let n = curve.degree();
        canvas.curve("before", -0.3..=0.0, |t| curve.at(t), Style::Extension);
        canvas.curve("after", 1.0..=1.3, |t| curve.at(t), Style::Extension);
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        for level in 1..=n {
            for (i, pair) in triangle.column(level - 1).windows(2).enumerate() {
                let nearer = if t > 0.5 { pair[1] } else { pair[0] };
                let name = format!("prolongation {level}.{i}");
                canvas.segment(&name, nearer, triangle.point(level, i), Style::Guide);
            }
            if level < n {
                let name = format!("level {level}");
                canvas.polyline(&name, triangle.column(level), Style::Level(level));
            }
        }
        canvas.point("b(t)", triangle.tip(), PointStyle::Result);
        canvas.label(&format!("b({})", decimal(t, 2)), triangle.tip());
        canvas.labels("b", curve.control_points());
        canvas.law(
            "bezier-bernstein-representation",
            &laws::bernstein_representation(BezierCurve::at, &curve, t),
        );
        if !(0.0..=1.0).contains(&t) {
            canvas.remark(
                "t is outside [0, 1]: one of the weights t and 1 − t is negative. The formulas hold; \
                 what needs convex combinations does not: b(t) may leave the convex hull of the control points.",
            );
        }
        remark_on_ends(canvas, t);
        Ok(())
    })
}

/// The triangular scheme for n = 3 with its numbers.
#[must_use]
pub fn de_casteljau_triangle() -> Figure {
    Figure::new(
        "bezier-de-casteljau-triangle",
        "The triangular scheme of the de Casteljau algorithm",
        "Four columns of points. The first holds the four control points. \
         From each two neighbours in a column two arrows lead to a point of the next column: \
         the one from the upper neighbour carries the weight 1 − t, the one from the lower neighbour the weight t. \
         The last column holds one point, the point of the curve.",
    )
    .slider("t", 0.0..=1.0, 0.4)
    .draw(|values, canvas| {
        let points = [[0.0, 0.0], [1.0, 3.0], [4.0, 3.0], [5.0, 0.0]];
        let curve = BezierCurve::new(points.map(Point::new))?;
        let t = values.number("t")?;
        let triangle = curve.triangle(t);
        canvas.law(
            "bezier-de-casteljau",
            &laws::de_casteljau(BezierCurve::triangle, &curve, t),
        );
        remark_on_ends(canvas, t);
        let columns = triangle.columns().enumerate().map(|(level, column)| {
            let entry = |(i, point): (usize, &Point<f64, 2>)| {
                let name = match level {
                    0 => format!("b_{i}"),
                    _ => format!("b_{i}^{level}"),
                };
                let [x, y] = [0, 1].map(|k| decimal(point[k], 3));
                format!("{name}\n({x}, {y})")
            };
            column.iter().enumerate().map(entry).collect::<Vec<_>>()
        });
        let scheme = Scheme::triangle(columns).weights("1-t", "t");
        canvas.scheme("scheme", &scheme);
        Ok(())
    })
}
