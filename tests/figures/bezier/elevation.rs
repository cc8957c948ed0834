//! Figures of the section on degree elevation and Bernstein approximation.

use cagd::affine::Affine;
use cagd::bezier::{BezierCurve, figures, laws, polygon_at};
use cagd::law::gamma;

use crate::support::{ensure, figure_test, near};

/// Each plotted polygon has the plotted curve, has r points more, and is closer than the one before.
#[test]
fn degree_elevation() {
    figure_test(figures::degree_elevation(), |plot| {
        let original = plot.polyline("0 elevations")?;
        let curve = BezierCurve::new(original.to_vec())?;
        let largest = original
            .iter()
            .flat_map(|p| [p[0], p[1]])
            .fold(0.0, f64::max);
        let second_difference = original
            .windows(3)
            .map(|p| ((p[2] - p[1]) - (p[1] - p[0])).norm());
        let second_difference = second_difference.fold(0.0, f64::max);
        let mut last_distance = f64::INFINITY;
        for times in [0, 1, 2, 5, 20] {
            let polygon = plot.polyline(&format!("{times} elevations"))?;
            ensure(polygon.len() == original.len() + times, || {
                format!("{} points after {times} elevations", polygon.len())
            })?;
            // Four roundings an elevation, three a level of de Casteljau on both sides.
            let bound = gamma(4 * times + 3 * (2 * original.len() + times)) * largest;
            let elevated = BezierCurve::new(polygon.to_vec())?;
            for (t, point) in plot.samples("curve")? {
                near("the curve of a polygon", elevated.at(t), point, bound)?;
            }
            let samples = plot.samples("curve")?;
            let gaps = samples.map(|(t, point)| polygon_at(polygon, t).difference(&point).norm());
            let distance = gaps.fold(0.0, f64::max);
            ensure(distance < last_distance, || {
                format!("after {times} elevations the polygon is no closer: {distance}")
            })?;
            // The bound of the statement: m(m − 1)/(8(m + r − 1)) times the second difference.
            let m = curve.degree() as f64;
            let allowed = m * (m - 1.0) / (8.0 * (m + times as f64 - 1.0)) * second_difference;
            ensure(distance <= allowed + bound, || {
                format!("after {times} elevations: {distance} is above the bound {allowed}")
            })?;
            last_distance = distance;
        }
        laws::degree_elevation(BezierCurve::elevated, &curve, 0.4)
            .judge()
            .map_err(Into::into)
    })
    .rejects("a polygon of another curve", |plot| {
        plot.shifted("2 elevations", [0.0, 0.1])
    })
    .rejects("polygons in the wrong order", |plot| {
        plot.swapped("1 elevations", "5 elevations")
    })
    .snapshot();
}

/// The approximations lie between F and F + 1/(2√m), and come closer with the degree.
#[test]
fn bernstein_approximation() {
    figure_test(figures::bernstein_approximation(), |plot| {
        let corner: Vec<f64> = plot.polyline("F")?.iter().map(|p| p[1]).collect();
        let mut last = vec![f64::INFINITY; corner.len()];
        for m in [2_usize, 8, 32] {
            let bound = 0.5 / (m as f64).sqrt();
            // Three roundings a level of de Casteljau, of values up to 1/2.
            let rounding = gamma(3 * m + 3);
            let graph = plot.polyline(&format!("degree {m}"))?;
            for ((value, corner), last) in graph.iter().map(|p| p[1]).zip(&corner).zip(&mut last) {
                ensure(
                    value >= corner - rounding && value <= corner + bound,
                    || format!("degree {m}: {value} beside {corner}"),
                )?;
                ensure(value <= *last + rounding, || {
                    format!("degree {m}: {value} is farther than {last}")
                })?;
                *last = value;
            }
        }
        Ok(())
    })
    .rejects("an approximation below the corner", |plot| {
        plot.shifted("degree 8", [0.0, -0.01])
    })
    .rejects("degrees mixed up", |plot| {
        plot.swapped("degree 2", "degree 32")
    })
    .snapshot();
}

/// The changed curve differs from the curve by B₅⁹(t) times the move: nowhere 0 inside.
#[test]
fn disadvantages() {
    figure_test(figures::disadvantages(), |plot| {
        let [from, to] = plot.segment("move")?;
        let mut points = plot.polyline("control polygon")?.to_vec();
        let number = points.iter().position(|point| *point == from);
        let number = number.ok_or("the arrow starts at no control point")?;
        points[number] = to;
        let changed = BezierCurve::new(points)?;
        let samples = plot.samples("curve")?.zip(plot.samples("changed curve")?);
        for ((t, point), (_, other)) in samples {
            near("the changed curve", changed.at(t), other, 0.0)?;
            let inside = t > 0.0 && t < 1.0;
            ensure(inside == (point.difference(&other).norm() > 0.0), || {
                format!("at t = {t} the curves are {point} and {other}")
            })?;
        }
        Ok(())
    })
    .rejects("a change of a part only", |plot| {
        let curve = plot.polyline("curve")?.to_vec();
        let mut local = plot.polyline("changed curve")?.to_vec();
        local[..80].copy_from_slice(&curve[..80]);
        plot.replaced("changed curve", local)
    })
    .rejects("an arrow from nowhere", |plot| {
        plot.shifted("move", [0.1, 0.0])
    })
    .snapshot();
}
