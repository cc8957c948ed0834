//! Figures of the section on distances and bounds.

use cagd::affine::{BoundingBox, ConvexHull, Point};
use cagd::bezier::bounds::{control_polygon_factor, maximum_norm};
use cagd::bezier::{BezierCurve, figures};

use crate::support::{ensure, figure_test};

/// No point of the drawn curve is farther from its chord point than the drawn strip is wide,
/// and the strip contains the curve.
#[test]
fn chord_bound() {
    figure_test(figures::chord_bound(), |plot| {
        let [start, end] = plot.segment("chord")?;
        let strip = plot.polygon("strip")?;
        // A corner of the strip stands straight across an end of the chord.
        let half_width = strip
            .iter()
            .map(|corner| (*corner - start).norm())
            .fold(f64::INFINITY, f64::min);
        for (t, point) in plot.samples("curve")? {
            let on_chord = start + (end - start) * t;
            let away = (point - on_chord).norm();
            ensure(away <= half_width, || {
                format!(
                    "the curve is {away} from the chord at t = {t}, the strip {half_width} wide"
                )
            })?;
        }
        let hull = ConvexHull::of(strip)?;
        let outside = plot
            .samples("curve")?
            .find(|(_, point)| !hull.contains(point));
        // Points at the very ends of the strip may be outside by rounding.
        ensure(outside.is_none_or(|(t, _)| t == 0.0 || t == 1.0), || {
            format!("{outside:?} is outside the strip")
        })
    })
    .rejects("a strip that is too narrow", |plot| {
        let [start, end] = plot.segment("chord")?;
        plot.replaced("strip", [start, end, end, start])
    })
    .rejects("a curve that leaves the strip", |plot| {
        plot.shifted("curve", [0.0, 2.5])
    })
    .snapshot();
}

/// The curve lies between both envelopes, which are the control polygon shifted by N‖Δ²b‖.
#[test]
fn control_polygon_bound() {
    figure_test(figures::control_polygon_bound(), |plot| {
        let polygon = plot.polyline("control polygon")?;
        let degree = polygon.len() - 1;
        let heights = BezierCurve::new(polygon.iter().map(|vertex| vertex[1]))?;
        let bound =
            control_polygon_factor::<f64>(degree) * heights.largest_second_difference(maximum_norm);
        for (name, shift) in [("upper envelope", bound), ("lower envelope", -bound)] {
            for (vertex, shifted) in std::iter::zip(polygon, plot.polyline(name)?) {
                ensure(
                    shifted[0] == vertex[0] && shifted[1] == vertex[1] + shift,
                    || format!("{shifted} of the {name} does not belong to {vertex}"),
                )?;
            }
        }
        for (t, point) in plot.samples("curve")? {
            let leg = ((t * degree as f64) as usize).min(degree - 1);
            let share = t * degree as f64 - leg as f64;
            let height = polygon[leg][1] * (1.0 - share) + polygon[leg + 1][1] * share;
            let away = (point[1] - height).abs();
            ensure(away <= bound, || {
                format!("{away} from the polygon at t = {t}")
            })?;
        }
        Ok(())
    })
    .rejects("an envelope that is too narrow", |plot| {
        plot.shifted("upper envelope", [0.0, -0.2])
    })
    .rejects("a curve outside the envelope", |plot| {
        plot.shifted("curve", [0.0, 1.5])
    })
    .snapshot();
}

/// Each distance is below the bound, the bound is divided by four in each step, the distance by at least three.
#[test]
fn uniform_convergence() {
    figure_test(figures::uniform_convergence(), |plot| {
        let bound = plot.polyline("distance/bound")?;
        let distance = plot.polyline("distance/distance")?;
        for (above, below) in std::iter::zip(bound, distance) {
            ensure(above[0] == below[0] && below[1] <= above[1], || {
                format!("the distance {below} is above the bound {above}")
            })?;
        }
        for step in bound.windows(2) {
            ensure(step[1][1] * 4.0 == step[0][1], || {
                format!("the bound falls from {} to {}", step[0], step[1])
            })?;
        }
        for step in distance.windows(2) {
            ensure(step[1][1] * 3.0 < step[0][1], || {
                format!("the distance falls from {} to {} only", step[0], step[1])
            })?;
        }
        Ok(())
    })
    .rejects("distances above the bound", |plot| {
        plot.swapped("distance/bound", "distance/distance")
    })
    .rejects("a bound that does not fall", |plot| {
        let flat = plot
            .polyline("distance/bound")?
            .iter()
            .map(|p| Point::new([p[0], 1.0]));
        let flat: Vec<_> = flat.collect();
        plot.replaced("distance/bound", flat)
    })
    .snapshot();
}

/// Every crossing lies in a surviving box of both curves, at each step, and on both curves.
#[test]
fn intersection_algorithm() {
    figure_test(figures::intersection_algorithm(), |plot| {
        for step in [1, 3, 5] {
            let panel = format!("step {step}");
            let crossings = plot.points(&format!("{panel}/crossings"))?;
            ensure(crossings.len() == 3, || {
                format!("{} crossings of the two cubics", crossings.len())
            })?;
            for curve in ["first", "second"] {
                let boxes: Vec<String> = plot
                    .names()
                    .filter(|(place, name)| {
                        *place == panel && name.starts_with(&format!("{curve} box"))
                    })
                    .map(|(place, name)| format!("{place}/{name}"))
                    .collect();
                for crossing in crossings {
                    let mut inside = false;
                    for name in &boxes {
                        let bounds = BoundingBox::of(plot.polygon(name)?)?;
                        // A crossing is computed on the first curve, to about 1e-12.
                        let near = |k: usize| {
                            bounds.low()[k] - 1e-9 <= crossing[k]
                                && crossing[k] <= bounds.high()[k] + 1e-9
                        };
                        inside |= near(0) && near(1);
                    }
                    ensure(inside, || {
                        format!("{crossing} is in no {curve} box after {step} halvings")
                    })?;
                }
            }
        }
        let chord = plot.segment("chord/chord of the arch")?;
        let segment = plot.polyline("chord/segment")?;
        ensure(
            segment
                .iter()
                .all(|point| point[1] > chord[0][1].max(chord[1][1])),
            || "the chord meets the segment".into(),
        )?;
        ensure(plot.points("chord/crossing")?.len() == 1, || {
            "the crossing with the arch is lost".into()
        })
    })
    .rejects("crossings off the curves", |plot| {
        plot.shifted("step 5/crossings", [0.0, 0.7])
    })
    .rejects("a segment that reaches the chord", |plot| {
        plot.shifted("chord/segment", [0.0, -0.5])
    })
    .snapshot();
}
