//! Figures of the section on distances and bounds.

use crate::affine::{Affine, Point};
use crate::bezier::bounds::{euclidean_norm, maximum_norm};
use crate::bezier::intersection::{IntersectionError, Intersections, Kind, Meeting};
use crate::bezier::{BezierCurve, PlaneCurve, laws};
use crate::figure::{Axes, Canvas, Figure, PointStyle, Style};

pub(super) fn all() -> Vec<Figure> {
    vec![
        chord_bound(),
        control_polygon_bound(),
        uniform_convergence(),
        intersection_algorithm(),
    ]
}

/// A cubic, its chord, and the strip of Wang's width around it.
#[must_use]
pub fn chord_bound() -> Figure {
    Figure::new(
        "bezier-chord-bound",
        "The curve stays in a strip around its chord",
        "A cubic Bézier curve with its chord and a shaded strip around the chord, \
         as wide as the bound by second differences says. \
         A dashed segment joins the curve point and the chord point of the same parameter; \
         it is never longer than half the width of the strip.",
    )
    .handles("b", [[0.0, 0.0], [2.5, 1.5], [5.5, 2.0], [9.0, 1.0]])
    .slider("t", 0.0..=1.0, 0.4)
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        let t = values.number("t")?;
        let points = curve.control_points();
        let (start, end) = (points[0], points[curve.degree()]);
        canvas.strip(
            "strip",
            start,
            end,
            curve.chord_bound(euclidean_norm),
            Style::Region,
        );
        canvas.polyline("control polygon", points, Style::ControlPolygon);
        canvas.segment("chord", start, end, Style::Tangent);
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        let on_chord = start.lerp(&end, t);
        canvas.segment("distance", curve.at(t), on_chord, Style::Guide);
        canvas.point("b(t)", curve.at(t), PointStyle::OnCurve);
        canvas.point("L(t)", on_chord, PointStyle::Guide);
        canvas.label("b(t)", curve.at(t));
        canvas.label("L(t)", on_chord);
        canvas.labels("b", points);
        canvas.law(
            "bezier-chord-bound",
            &laws::chord_bound(|curve| curve.chord_bound(maximum_norm), &curve, t),
        );
        if curve.chord_bound(maximum_norm) == 0.0 {
            canvas.remark(NO_SECOND_DIFFERENCES);
        } else if start == end {
            canvas.remark(
                "The curve ends where it starts. The chord is a point, and the bound holds all the same: \
                 it needs no direction.",
            );
        }
        Ok(())
    })
}

/// What is to be seen where the bounds are 0.
const NO_SECOND_DIFFERENCES: &str = "All second differences are 0, and so are the bounds: \
     the curve runs along its chord at constant speed, and polygon and curve are the same.";

/// The graph of a quartic with its control polygon and the envelope around it.
#[must_use]
pub fn control_polygon_bound() -> Figure {
    Figure::new(
        "bezier-control-polygon-bound",
        "The curve stays in an envelope around its control polygon",
        "The graph of a polynomial of degree 4 over the interval from 0 to 1 with its control polygon, \
         whose vertices stand at 0, 1/4, 1/2, 3/4 and 1. \
         Two dotted copies of the polygon, shifted up and down by the bound, enclose the graph.",
    )
    .handles(
        "b",
        [[0.0, 0.0], [0.25, 2.0], [0.5, 2.5], [0.75, 1.5], [1.0, 2.5]],
    )
    .draw(|values, canvas| {
        // Only the heights count: the vertices stand over k/n.
        let heights: Vec<f64> = values.points("b")?.iter().map(|place| place[1]).collect();
        let function = BezierCurve::new(heights)?;
        let bound = function.control_polygon_bound(maximum_norm);
        let polygon = function.corner_cutting().next().into_iter();
        let polygon: Vec<Point<f64, 2>> = polygon
            .flat_map(|polygon| {
                let legs = 0..polygon.legs();
                let vertices = legs.clone().map(|leg| polygon.on_leg(leg, 0.0));
                let last = legs.last().map(|leg| polygon.on_leg(leg, 1.0));
                vertices.chain(last).collect::<Vec<_>>()
            })
            .map(|(t, height)| Point::new([t, height]))
            .collect();
        canvas.axes(Axes::new("t", "b"));
        for (name, shift) in [("upper envelope", bound), ("lower envelope", -bound)] {
            let shifted = polygon.iter().map(|p| Point::new([p[0], p[1] + shift]));
            canvas.polyline(name, shifted, Style::Bound);
        }
        canvas.polyline("control polygon", polygon, Style::ControlPolygon);
        canvas.graph("curve", 0.0..=1.0, |t| function.at(t), Style::Curve);
        canvas.legend("bound", Style::Bound);
        canvas.law(
            "bezier-control-polygon-bound",
            &laws::control_polygon_bound(|f| f.control_polygon_bound(maximum_norm), &function, 1, 1.0),
        );
        if bound == 0.0 {
            canvas.remark(NO_SECOND_DIFFERENCES);
        }
        Ok(())
    })
}

/// How many halvings are measured.
const HALVINGS: usize = 6;

/// The largest distance of polygon and curve after k halvings, beside the bound.
#[must_use]
pub fn uniform_convergence() -> Figure {
    Figure::new(
        "bezier-uniform-convergence",
        "The distance of polygon and curve is divided by four in each step",
        "Two panels. The first shows a quartic Bézier curve with its control polygon. \
         The second shows, on a logarithmic scale against the number k of halvings from 0 to 6, \
         the largest distance between polygon and curve, and above it the bound; \
         both fall along straight lines with the slope minus logarithm of 4.",
    )
    .handles_in(
        "curve",
        "b",
        [[0.0, 0.0], [1.0, 4.0], [4.0, 5.0], [6.5, 4.5], [7.0, 0.0]],
    )
    .rows(&[&["curve"], &["distance"]])
    .draw(|values, canvas| {
        let curve = BezierCurve::new(values.points("b")?)?;
        canvas.panel("curve");
        canvas.polyline(
            "control polygon",
            curve.control_points(),
            Style::ControlPolygon,
        );
        canvas.curve("curve", 0.0..=1.0, |t| curve.at(t), Style::Curve);
        canvas.labels("b", curve.control_points());
        canvas.panel("distance");
        canvas.axes(Axes::new("k", "distance").logarithmic().whole());
        // A logarithm needs positive numbers; a curve that is a point has the distance 0.
        let positive = |distance: f64| distance.max(1e-9);
        let bound = curve.control_polygon_bound(euclidean_norm);
        let bounds = (0..=HALVINGS).map(|k| {
            let quartered = bound / 4f64.powi(k as i32);
            Point::new([k as f64, positive(quartered)])
        });
        canvas.polyline("bound", bounds, Style::Bound);
        let distances = curve.corner_cutting().take(HALVINGS + 1).map(|polygon| {
            let largest = (0..polygon.legs())
                .flat_map(|leg| [0.0, 0.25, 0.5, 0.75, 1.0].map(|lambda| (leg, lambda)))
                .map(|(leg, lambda)| polygon.on_leg(leg, lambda))
                .map(|(u, point)| euclidean_norm(&(point - curve.at(u))))
                .fold(0.0, f64::max);
            Point::new([polygon.step() as f64, positive(largest)])
        });
        canvas.polyline("distance", distances, Style::Level(1));
        canvas.legend("largest distance", Style::Level(1));
        canvas.legend("bound", Style::Bound);
        canvas.law(
            "bezier-uniform-convergence",
            &laws::uniform_convergence(vertices, &curve, 3, 13, 0.5),
        );
        if bound == 0.0 {
            canvas.remark(NO_SECOND_DIFFERENCES);
        }
        Ok(())
    })
}

/// The control polygon after some halvings.
fn vertices(curve: &PlaneCurve, steps: usize) -> Vec<Point<f64, 2>> {
    let polygon = curve.corner_cutting().nth(steps);
    polygon.map_or_else(Vec::new, |polygon| polygon.vertices().to_vec())
}

/// The pieces whose boxes survive, after 1, 3 and 5 halvings, and the case that chords alone would lose.
#[must_use]
pub fn intersection_algorithm() -> Figure {
    Figure::new(
        "bezier-intersection-algorithm",
        "Intersecting two curves by halving boxes",
        "Four panels. The first three show two cubic Bézier curves that cross, with the bounding boxes of those \
         pieces of step 1, 3 and 5 that still meet a box of the other curve; they close in on the crossings, \
         which are marked by crosses. The last panel shows a flat arch and a short vertical segment that crosses it; \
         the dashed chord of the arch passes below the segment without touching it.",
    )
    .handles_in("step 1", "p", [[0.0, 1.0], [3.0, 8.0], [6.0, -3.0], [9.0, 4.5]])
    .handles_in("step 1", "q", [[0.5, 4.5], [3.5, -2.5], [6.0, 7.5], [9.0, 1.0]])
    .slider("h", 0.1..=0.3, 0.3)
    .rows(&[&["step 1", "step 3"], &["step 5", "chord"]])
    .draw(|values, canvas| {
        let [p, q] = [values.points("p")?, values.points("q")?];
        let curves = [BezierCurve::new(p)?, BezierCurve::new(q)?];
        let (crossings, finished) = crossings(&curves[0], &curves[1])?;
        for step in [1, 3, 5] {
            canvas.panel(&format!("step {step}"));
            canvas.caption(&format!("$k = {step}$"));
            surviving_boxes(canvas, &curves, step)?;
            canvas.curve("first curve", 0.0..=1.0, |t| curves[0].at(t), Style::Curve);
            canvas.curve("second curve", 0.0..=1.0, |t| curves[1].at(t), Style::SecondCurve);
            let places = crossings
                .iter()
                .map(|meeting| curves[0].at(meeting.first.middle()));
            canvas.points("crossings", places, PointStyle::Cross);
        }
        let h = values.number("h")?;
        let arch = BezierCurve::new([[0.0, 0.0], [0.5, 2.0 * h], [1.0, 0.0]].map(Point::new))?;
        let post = BezierCurve::new([[0.5, 0.5 * h], [0.5, 2.0 * h]].map(Point::new))?;
        canvas.panel("chord");
        canvas.caption("the chord alone would miss");
        canvas.curve("arch", 0.0..=1.0, |t| arch.at(t), Style::Curve);
        canvas.curve("segment", 0.0..=1.0, |t| post.at(t), Style::SecondCurve);
        canvas.segment("chord of the arch", arch.at(0.0), arch.at(1.0), Style::Guide);
        let found = arch.intersections(&post, h)?;
        let places = found.meetings.iter().map(|meeting| arch.at(meeting.first.middle()));
        canvas.points("crossing", places, PointStyle::Cross);
        canvas.law(
            "bezier-intersection-algorithm",
            &laws::intersection_algorithm(|_, _| crossings.clone(), [&curves[0], &curves[1]], &[]),
        );
        let overlap = crossings
            .iter()
            .any(|meeting| matches!(meeting.kind, Kind::Overlap { .. }));
        if overlap || !finished {
            canvas.remark(
                "The curves have a common piece, or nearly so: its boxes meet at every step, however small they are. \
                 That halving singles out the intersections needs finitely many of them.",
            );
        } else if crossings.is_empty() {
            canvas.remark("The curves do not meet: after some halvings no box meets another, and the algorithm ends.");
        }
        Ok(())
    })
}

/// The boxes where two curves meet, with a tolerance that suits a drawing, and whether these are all.
fn crossings(
    first: &PlaneCurve,
    second: &PlaneCurve,
) -> Result<(Vec<Meeting>, bool), IntersectionError> {
    let size = [first, second]
        .iter()
        .flat_map(|curve| curve.control_points())
        .flat_map(|point| point.coordinates().to_vec())
        .fold(1.0, |largest: f64, x| largest.max(x.abs()));
    match first.intersections_within(second, 1e-4 * size, 2000) {
        Ok(Intersections { meetings, .. }) => Ok((meetings, true)),
        // A reader may drag the curves into each other; then the boxes found so far are shown.
        Err(IntersectionError::TooMuchWork { found, .. }) => Ok((found.meetings, false)),
        Err(other) => Err(other),
    }
}

/// Draws the boxes of the pieces of this step that meet a box of the other curve.
fn surviving_boxes(
    canvas: &mut Canvas,
    curves: &[PlaneCurve; 2],
    step: usize,
) -> Result<(), crate::figure::BoxError> {
    let pairs = curves[0].surviving_pairs(&curves[1], step);
    let whole = f64::from(1u32 << step);
    for (k, (name, curve)) in std::iter::zip(["first", "second"], curves).enumerate() {
        let mut starts: Vec<usize> = pairs
            .iter()
            .map(|pair| (pair[k].low() * whole).round() as usize)
            .collect();
        starts.sort_unstable();
        starts.dedup();
        let pieces = curve.corner_cutting().nth(step);
        for (index, points) in pieces.iter().flat_map(|p| p.pieces()).enumerate() {
            if starts.contains(&index) {
                let bounds = BezierCurve::new(points.to_vec())?.bounding_box();
                let style = if k == 0 { Style::Bound } else { Style::Guide };
                let box_name = format!("{name} box {index}");
                canvas.rectangle(&box_name, bounds.low(), bounds.high(), style);
            }
        }
    }
    Ok(())
}
