//! Figures of the section on limit points.

use super::corner_cutting::remark_on_one_place;
use crate::affine::Point;
use crate::bspline::uniform_b_spline;
use crate::figure::{Figure, PointStyle, Style};
use crate::scalar::{BigRational, Scalar, exact};
use crate::subdivision::{LaurentPolynomial, Mask, laws};

pub(super) fn all() -> Vec<Figure> {
    vec![limit_stencils()]
}

/// The limit point and the tangent that belong to each vertex, without any subdivision.
#[must_use]
pub fn limit_stencils() -> Figure {
    Figure::new(
        "subdivision-limit-stencils",
        "Limit points and tangents of all vertices",
        "A closed polygon of six points. For every vertex a stencil gives the point of the limit curve that belongs to it, \
         and another one the derivative there, drawn as an arrow of a third of its length. \
         The limit curve, computed by five steps of subdivision, passes through all these points and touches the arrows. \
         The scheme can be chosen: Chaikin, cubic, of degree 4, four-point.",
    )
    .choice("scheme", &["Chaikin", "cubic", "degree 4", "four-point"], 1)
    .handles("p", [[0.0, 0.4], [1.0, 3.2], [3.0, 3.6], [4.2, 1.2], [6.6, 1.8], [4.8, -0.8]])
    .draw(|values, canvas| {
        let points: Vec<Point<f64, 2>> = values.points("p")?;
        let scheme = values.count("scheme")? + 1;
        let mask: Mask<BigRational> = match scheme {
            1..=3 => Mask::lane_riesenfeld(scheme + 1),
            _ => Mask::four_point(BigRational::from_ratio(1, 16))?,
        };
        // The limit of a single point lies over the support of the mask; its middle belongs to the point.
        let support = mask.support();
        let doubled_middle = support.start + support.end - 1;
        let position = mask.limit_stencil_at(0, doubled_middle, 1)?.to_f64();
        let derivative = mask.limit_stencil_at(1, doubled_middle, 1)?.to_f64();
        let rounded: Mask<f64> = match scheme {
            1..=3 => Mask::lane_riesenfeld(scheme + 1),
            _ => Mask::four_point(1.0 / 16.0)?,
        };
        let mut curve = points.clone();
        for _ in 0..5 {
            curve = rounded.refine_closed(&curve)?;
        }
        curve.extend(curve.first().copied());
        let polygon = points.iter().chain(points.first());
        canvas.polyline("polygon", polygon, Style::ControlPolygon);
        canvas.polyline("curve", curve, Style::Curve);
        let mut limits = vec![];
        for (i, _) in points.iter().enumerate() {
            let limit = position.of_closed(&points, i as i64);
            let tip = limit + derivative.derivative_of_closed(&points, i as i64) / 3.0;
            canvas.arrow(&format!("tangent {i}"), limit, tip, Style::Tangent);
            limits.push(limit);
        }
        canvas.points("limit points", limits, PointStyle::Result);
        canvas.labels("p", &points);
        // What is known of the limit otherwise: it is a spline, or it interpolates.
        let whole = <BigRational as Scalar>::from_integer;
        let known = |j: i64| match scheme {
            1..=3 => uniform_b_spline(scheme + 1, whole(-j)),
            _ => whole(i64::from(j == 0)),
        };
        let across: Option<Vec<BigRational>> = points.iter().map(|p| exact(p[0])).collect();
        let across = LaurentPolynomial::new(0, across.ok_or("finite points")?);
        canvas.law(
            "subdivision-limit-stencils",
            &laws::limit_stencils(|mask| mask.limit_stencil(0).ok(), &mask, known, &across),
        );
        remark_on_one_place(canvas, &points);
        Ok(())
    })
}
