//! Figures of the section on uniform splines.

use cagd::affine::{Affine, Point};
use cagd::figure::Place;
use cagd::subdivision::figures;

use super::corner_cutting::same;
use crate::support::{ensure, figure_test, near};

/// The refined polygon has the edge and vertex points; the limit of a vertex is a sixth of the sum with weights 1, 4, 1,
/// on the curve, and its tangent is parallel to the chord of the neighbours.
#[test]
fn cubic_curve() {
    figure_test(figures::cubic_curve(), |plot| {
        // Coordinates below 8, at most 30 roundings.
        let bound = 30.0 * 8.0 * f64::EPSILON;
        let given = plot.polyline("steps/polygon")?;
        let mean = |i: usize, weights: [f64; 3]| {
            let [before, here, after] = [i - 1, i, i + 1].map(|i| given[i].from_origin());
            let sum: f64 = weights.iter().sum();
            Point::origin() + (before * weights[0] + here * weights[1] + after * weights[2]) / sum
        };
        let mut expected: Vec<Place> = vec![given[0].lerp(&given[1], 0.5)];
        for i in 1..given.len() - 1 {
            expected.push(mean(i, [1.0, 6.0, 1.0]));
            expected.push(given[i].lerp(&given[i + 1], 0.5));
        }
        same(
            "one step",
            plot.polyline("steps/refined")?,
            &expected,
            bound,
        )?;
        let samples: Vec<Place> = plot
            .samples("limits/limit")?
            .map(|(_, point)| point)
            .collect();
        for i in 1..given.len() - 1 {
            let limit = plot.point(&format!("limits/limit {i}"))?;
            near("a limit", limit, mean(i, [1.0, 4.0, 1.0]), bound)?;
            // 240 samples over 3 segments.
            near("the curve", samples[80 * (i - 1)], limit, bound)?;
            let [start, end] = plot.segment(&format!("limits/tangent {i}"))?;
            let (tangent, chord) = (end - start, given[i + 1] - given[i - 1]);
            let across = tangent[0] * chord[1] - tangent[1] * chord[0];
            ensure(across.abs() <= 8.0 * bound, || {
                format!("the tangent {i} is not parallel to the chord")
            })?;
            near(
                "the middle of the tangent",
                start.lerp(&end, 0.5),
                limit,
                bound,
            )?;
        }
        Ok(())
    })
    .rejects("vertices in the place of limits", |plot| {
        let vertex = plot.polyline("steps/polygon")?[2];
        plot.replaced("limits/limit 2", [vertex])
    })
    .rejects("a tangent beside its point", |plot| {
        plot.shifted("limits/tangent 1", [0.0, 0.1])
    })
    .rejects("a refined polygon that is moved", |plot| {
        plot.shifted("steps/refined", [0.05, 0.0])
    })
    .snapshot();
}
