//! Figures of the section on corner cutting.

use cagd::affine::{Affine, Point};
use cagd::figure::Place;
use cagd::subdivision::{ControlPolygon, figures};

use crate::support::{Checked, ensure, figure_test, near};

/// Equal lists of places, up to `bound`.
pub(crate) fn same(what: &str, found: &[Place], expected: &[Place], bound: f64) -> Checked {
    ensure(found.len() == expected.len(), || {
        format!(
            "{what}: {} points, expected {}",
            found.len(),
            expected.len()
        )
    })?;
    std::iter::zip(found, expected).try_for_each(|(&f, &e)| near(what, f, e, bound))
}

/// The cuts of every leg at a quarter and at three quarters, leg by leg.
fn quarter_cuts(legs: &[[Place; 2]]) -> Vec<Place> {
    legs.iter()
        .flat_map(|[start, end]| [0.25, 0.75].map(|t| start.lerp(end, t)))
        .collect()
}

fn legs(vertices: &[Place], closed: bool) -> Vec<[Place; 2]> {
    let next = vertices.iter().cycle().skip(1);
    let count = vertices.len() - usize::from(!closed);
    std::iter::zip(vertices, next)
        .take(count)
        .map(|(a, b)| [*a, *b])
        .collect()
}

/// A coordinate below 8 after 6 steps with at most 6 roundings each.
const ROUNDING: f64 = 36.0 * 8.0 * f64::EPSILON;

/// On the right every eighth vertex is given, and the first new one is that of the four-point rule;
/// on the left none of the given vertices is left, but the middles of the legs are.
#[test]
fn approximating_interpolating() {
    figure_test(figures::approximating_interpolating(), |plot| {
        let given = plot.polygon("approximating/polygon")?;
        let kept = plot.polygon("interpolating/refined")?;
        let every_eighth: Vec<Place> = kept.iter().step_by(8).copied().collect();
        same("the kept vertices", &every_eighth, given, 0.0)?;
        let [before, start, end, after] = [5, 0, 1, 2].map(|i: usize| given[i].from_origin());
        let inserted = (start + end) * 0.5625 - (before + after) * 0.0625;
        near(
            "the first point of the four-point rule",
            kept[4],
            Point::origin() + inserted,
            ROUNDING,
        )?;

        let mut cut = given.to_vec();
        for _ in 0..3 {
            cut = quarter_cuts(&legs(&cut, true));
        }
        same(
            "three steps of Chaikin",
            plot.polygon("approximating/refined")?,
            &cut,
            ROUNDING,
        )
    })
    .rejects("a refined polygon beside the given vertices", |plot| {
        plot.shifted("interpolating/refined", [0.05, 0.0])
    })
    .rejects("both refined polygons exchanged", |plot| {
        plot.swapped("approximating/refined", "interpolating/refined")
    })
    .snapshot();
}

/// Each polygon is cut from the one before, and the limit runs through the middles of the legs, along them.
#[test]
fn figure_chaikin() {
    figure_test(figures::figure_chaikin(), |plot| {
        let given = plot.polyline("k = 1/polygon")?;
        let mut cut = given.to_vec();
        for k in 1..=3 {
            cut = quarter_cuts(&legs(&cut, false));
            let item = format!("k = {k}/refined");
            same(&item, plot.polyline(&item)?, &cut, ROUNDING)?;
        }
        // 240 samples over 3 segments: the joints are samples 0, 80, 160 and 240.
        let samples: Vec<Place> = plot
            .samples("limit/limit")?
            .map(|(_, point)| point)
            .collect();
        for (i, [start, end]) in legs(given, false).into_iter().enumerate() {
            near(
                "a joint of the limit",
                samples[80 * i],
                start.lerp(&end, 0.5),
                ROUNDING,
            )?;
        }
        let once = quarter_cuts(&legs(given, false));
        same(
            "the chosen step",
            plot.polyline("limit/refined")?,
            &once,
            0.0,
        )
    })
    .rejects("a polygon of another step", |plot| {
        plot.swapped("k = 1/refined", "k = 2/refined")
    })
    .rejects("a limit beside the middles", |plot| {
        plot.shifted("limit/limit", [0.0, 0.02])
    })
    .snapshot();
}

/// The measured distances are those of the formula, which begins with an eighth of the largest second difference
/// and falls by the factor 4.
#[test]
fn chaikin_convergence() {
    figure_test(figures::chaikin_convergence(), |plot| {
        let given = plot.polygon("curve/polygon")?;
        let count = given.len();
        let largest = (0..count)
            .map(|i| {
                let [before, here, after] = [i + count - 1, i, i + 1].map(|i| given[i % count]);
                ((after - here) - (here - before)).norm()
            })
            .fold(0.0, f64::max);
        let formula = plot.polyline("distance/formula")?;
        near(
            "the first distance",
            formula[0],
            Point::new([0.0, largest / 8.0]),
            ROUNDING,
        )?;
        for step in formula.windows(2) {
            ensure(step[1][1] * 4.0 == step[0][1], || {
                format!("the formula falls from {} to {}", step[0], step[1])
            })?;
        }
        let spline = ControlPolygon::closed(given.to_vec())?.spline(2)?;
        for (u, point) in plot.samples("curve/spline")? {
            near("the spline", point, spline.at(u)?, 0.0)?;
        }
        // The spline passes 16 roundings and a parameter in [0, 5] that is off by 4 of them, the polygon 12.
        same(
            "the measured distances",
            plot.points("distance/measured")?,
            formula,
            3.0 * ROUNDING,
        )
    })
    .rejects("distances that do not fall", |plot| {
        let level: Vec<Place> = (0..=6).map(|k| Point::new([f64::from(k), 0.5])).collect();
        plot.replaced("distance/measured", level)
    })
    .rejects("half of each distance", |plot| {
        let halves: Vec<Place> = plot
            .points("distance/measured")?
            .iter()
            .map(|p| Point::new([p[0], p[1] / 2.0]))
            .collect();
        plot.replaced("distance/measured", halves)
    })
    .snapshot();
}

/// Each round joins the middles of the legs of the round before, and the limit is the cubic spline.
#[test]
fn figure_lane_riesenfeld() {
    figure_test(figures::figure_lane_riesenfeld(), |plot| {
        let given = plot.polyline("round 1/polygon")?;
        let mut round: Vec<Place> = given.iter().flat_map(|p| [*p, *p]).collect();
        for number in 1..=3 {
            round = legs(&round, false)
                .iter()
                .map(|[start, end]| start.lerp(end, 0.5))
                .collect();
            let item = format!("round {number}/averaged");
            same(&item, plot.polyline(&item)?, &round, 0.0)?;
        }
        ensure(round.len() == 7, || {
            format!("{} points after three rounds", round.len())
        })?;
        same("the result", plot.polyline("limit/result")?, &round, 0.0)?;
        let samples: Vec<Place> = plot
            .samples("limit/limit")?
            .map(|(_, point)| point)
            .collect();
        // Two segments: the joints are samples 0, 120 and 240, the limits of the inner vertices.
        for i in 1..=3 {
            let [before, here, after] = [i - 1, i, i + 1].map(|i| given[i].from_origin());
            let position = Point::origin() + (before + here * 4.0 + after) / 6.0;
            near(
                "a joint of the limit",
                samples[120 * (i - 1)],
                position,
                ROUNDING,
            )?;
        }
        Ok(())
    })
    .rejects("two rounds exchanged", |plot| {
        plot.swapped("round 2/averaged", "round 3/averaged")
    })
    .rejects("another limit", |plot| {
        plot.shifted("limit/limit", [0.0, 0.02])
    })
    .snapshot();
}
