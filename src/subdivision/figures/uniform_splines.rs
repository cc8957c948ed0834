//! Figures of the section on uniform splines.

use super::corner_cutting::{draw_polygon, draw_spline, refined, remark_on_one_place, stepped};
use crate::figure::{Figure, PointStyle, Style};
use crate::subdivision::{ControlPolygon, laws};

pub(super) fn all() -> Vec<Figure> {
    vec![cubic_curve()]
}

/// The cubic scheme: its first steps, and the limits of the vertices with their tangents.
#[must_use]
pub fn cubic_curve() -> Figure {
    const PANELS: [&str; 2] = ["steps", "limits"];
    Figure::new(
        "subdivision-cubic-curve",
        "The cubic scheme and the limits of the vertices",
        "Two panels with the same open polygon of six vertices. \
         The first shows the polygon after a chosen number of steps of the cubic scheme: \
         every leg has got a point in its middle and every inner vertex a point near to it. \
         The second shows the limit curve with a point for each inner vertex, on the way from the vertex to the middle of its neighbours, \
         and there a tangent that is parallel to the chord between the neighbours.",
    )
    .rows(&[&PANELS])
    .handles_in(
        PANELS[0],
        "p",
        [[0.0, 1.0], [0.6, 3.6], [3.6, 4.0], [4.4, 0.6], [7.2, 0.0], [8.0, 3.0]],
    )
    .stepper("k", 0..=5, 1)
    .draw(|values, canvas| {
        let given = ControlPolygon::open(values.points("p")?)?;
        let spline = given.spline(3)?;
        let derivative = spline.derivative()?;
        canvas.panel(PANELS[0]);
        let steps = values.count("k")?;
        canvas.caption(&format!("$k = {steps}$"));
        let refined = refined(&given, steps, ControlPolygon::cubic_step)?;
        draw_polygon(canvas, "polygon", &given, Style::ControlPolygon);
        draw_polygon(canvas, "refined", &refined, Style::SecondPolygon);
        canvas.labels("p", given.vertices());

        canvas.panel(PANELS[1]);
        canvas.caption("limits of the vertices");
        draw_polygon(canvas, "polygon", &given, Style::ControlPolygon);
        draw_spline(canvas, "limit", &spline);
        for i in 1..given.vertices().len() - 1 {
            let knot = spline.domain().start() + (i - 1) as f64;
            let (point, vector) = (spline.at(knot)?, derivative.at(knot)?);
            canvas.segment(&format!("way {i}"), given.vertices()[i], point, Style::Guide);
            canvas.segment(
                &format!("tangent {i}"),
                point - vector * 0.25,
                point + vector * 0.25,
                Style::Tangent,
            );
            canvas.point(&format!("limit {i}"), point, PointStyle::OnCurve);
        }
        let step = stepped(ControlPolygon::cubic_step);
        canvas.law("subdivision-cubic-curve", &laws::cubic_curve(step, &given));
        remark_on_one_place(canvas, given.vertices());
        Ok(())
    })
}
