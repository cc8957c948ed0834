//! Figures of the section on the algorithm of de Casteljau.

use crate::bezier::BezierCurve;
use crate::figure::{Figure, PointStyle, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![figure_de_casteljau()]
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
        }
        Ok(())
    })
}
