//! Figures of the section on blossoms.

use crate::bezier::{BezierCurve, laws};
use crate::figure::{Figure, PointStyle, Scheme, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![blossom_de_casteljau()]
}

/// The names of start, parameter and end in the labels of blossom values.
const NAMES: [&str; 3] = ["0", "t", "1"];

/// The triangle of blossom values of a cubic beside the points of the construction.
#[must_use]
pub fn blossom_de_casteljau() -> Figure {
    const PANELS: [&str; 2] = ["triangle", "construction"];
    Figure::new(
        "bezier-blossom-de-casteljau",
        "The algorithm of de Casteljau in terms of the blossom",
        "Above, a triangle of blossom values of a cubic: the column of the control points p(0,0,0), p(0,0,1), p(0,1,1), p(1,1,1), \
         then p(0,0,t), p(0,t,1), p(t,1,1), then p(0,t,t), p(t,t,1), and at the tip p(t,t,t). \
         Heavy arrows mark the upper side of the triangle, the control points of the piece over [0, t], \
         and the lower side, those of the piece over [t, 1]. \
         Below, the same values as points of the construction, where the two pieces have their own polygons.",
    )
    .rows(&[&PANELS[..1], &PANELS[1..]])
    .slider("t", 0.0..=1.0, 0.4)
    .handles_in(
        PANELS[1],
        "b",
        [[0.0, 0.0], [1.0, 4.4], [6.6, 4.8], [9.0, 0.4]],
    )
    .draw(|values, canvas| {
        let t = values.number("t")?;
        let curve = BezierCurve::new(values.points("b")?)?;
        let triangle = curve.blossom().triangle(t);
        let n = triangle.degree();

        canvas.panel(PANELS[0]);
        let columns = (0..=n).map(|level| {
            let column = triangle.column(level);
            column.map(|entry| entry.label(NAMES)).collect::<Vec<_>>()
        });
        let mut scheme = Scheme::triangle(columns);
        for level in 0..n {
            scheme = scheme.highlighted(level, 0, 0);
            scheme = scheme.highlighted(level, n - level, n - level - 1);
        }
        canvas.scheme("scheme", &scheme);

        canvas.panel(PANELS[1]);
        let points = triangle.points();
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.polyline(
            "control polygon",
            points.column(0),
            Style::ControlPolygon,
        );
        for level in 1..n {
            let name = format!("level {level}");
            canvas.polyline(&name, points.column(level), Style::Level(level));
        }
        canvas.point("p(t,t,t)", points.tip(), PointStyle::Result);
        for level in 0..=n {
            for entry in triangle.column(level) {
                canvas.label(&entry.label(NAMES), entry.point);
            }
        }
        canvas.law(
            "bezier-blossom-de-casteljau",
            &laws::blossom_de_casteljau(|curve, t| curve.blossom().triangle(t), &curve, t, 0.5),
        );
        if t == 0.0 || t == 1.0 {
            canvas.remark(
                "t is an end of the interval: one side of the triangle repeats a single point, \
                 the control polygon of a piece over an interval of length 0.",
            );
        }
        Ok(())
    })
}
