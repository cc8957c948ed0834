//! Figures of the section on subdivision.

use cagd::affine::Point;
use cagd::bezier::{BezierCurve, figures, laws};

use crate::support::{ensure, figure_test};

/// Both drawn polygons obey the law of subdivision at the drawn α, with the drawn control polygon.
#[test]
fn figure_subdivision() {
    figure_test(figures::figure_subdivision(), |plot| {
        let curve = BezierCurve::new(plot.polyline("control polygon")?.to_vec())?;
        let left = BezierCurve::new(plot.polyline("left polygon")?.to_vec())?;
        let right = BezierCurve::new(plot.polyline("right polygon")?.to_vec())?;
        for t in [0.25, 0.6, 1.5] {
            let drawn = |_: &BezierCurve<Point<f64, 2>>, _| [left.clone(), right.clone()];
            laws::subdivision(drawn, &curve, 0.4, t).judge()?;
        }
        let meet = plot.point("b(alpha)")?;
        ensure(
            plot.samples("left piece")?.last() == Some((1.0, meet)),
            || format!("the left piece does not end in {meet}"),
        )
    })
    .rejects("the pieces swapped", |plot| {
        plot.swapped("left polygon", "right polygon")
    })
    .rejects("a polygon beside the scheme", |plot| {
        plot.shifted("right polygon", [0.0, 0.1])
    })
    .snapshot();
}

/// Each new leg is at most half as long as the longest leg of the control polygon, and all six are labelled.
#[test]
fn figure_corner_cutting() {
    figure_test(figures::figure_corner_cutting(), |plot| {
        let legs = |points: &[Point<f64, 2>]| -> Vec<f64> {
            points
                .windows(2)
                .map(|leg| (leg[1] - leg[0]).norm())
                .collect()
        };
        let longest = legs(plot.polyline("control polygon")?)
            .into_iter()
            .fold(0.0, f64::max);
        let left = legs(plot.polyline("left polygon")?);
        let right = legs(plot.polyline("right polygon")?);
        for leg in left.iter().chain(&right) {
            // Means and lengths pass a dozen roundings.
            ensure(*leg <= 0.5 * longest * (1.0 + 1e-14), || {
                format!("a new leg is {leg} long, more than half of {longest}")
            })?;
        }
        let first = plot.polyline("left polygon")?[1];
        let start = plot.polyline("control polygon")?;
        ensure((first - start[0]) * 2.0 == start[1] - start[0], || {
            "the first new leg is not half of the first old one".into()
        })?;
        let labels = plot
            .labels()
            .filter(|(text, _)| text.ends_with('d'))
            .count();
        ensure(labels == 6, || format!("{labels} lengths are labelled"))
    })
    .rejects("a new polygon that is not cut", |plot| {
        let points = plot.polyline("control polygon")?.to_vec();
        plot.replaced("right polygon", points)
    })
    .rejects("legs that are too long", |plot| {
        plot.scaled("left polygon", 1.5)
    })
    .snapshot();
}

/// The polygon of each panel obeys the law of corner cutting for its step.
#[test]
fn corner_cutting_convergence() {
    figure_test(figures::corner_cutting_convergence(), |plot| {
        let curve = BezierCurve::new(plot.polyline("k = 0/polygon")?.to_vec())?;
        for step in 0..4 {
            let drawn = plot.polyline(&format!("k = {step}/polygon"))?.to_vec();
            laws::corner_cutting_convergence(|_, _| drawn.clone(), &curve, step).judge()?;
        }
        Ok(())
    })
    .rejects("two steps swapped", |plot| {
        plot.swapped("k = 1/polygon", "k = 2/polygon")
    })
    .rejects("a polygon off the curve", |plot| {
        plot.shifted("k = 3/polygon", [0.0, 0.1])
    })
    .snapshot();
}
