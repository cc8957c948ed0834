//! Figures of affine combinations.

use cagd::affine::{figures, point_seen_from};
use cagd::figure::Place;
use cagd::law::gamma;

use crate::support::{ensure, figure_test, near};

/// The line and the segment join the tips, and the marked point is −a/2 + 3b/2, which is on that line.
#[test]
fn figure_combinations() {
    figure_test(figures::figure_combinations(), |plot| {
        let [origin, a] = plot.segment("a")?;
        let [foot, b] = plot.segment("b")?;
        near("the foot of b", foot, origin, 0.0)?;
        for name in ["affine combinations", "convex combinations"] {
            let [from, to] = plot.segment(name)?;
            near("from the tip of a", from, a, 0.0)?;
            near("to the tip of b", to, b, 0.0)?;
        }
        // Seen from the tip of a instead of the origin: 4 roundings, and 3 of what is drawn, of terms up to 3·3.
        let expected = point_seen_from(&a, &[(-0.5, a), (1.5, b)]);
        let point = plot.point("combination")?;
        near("−a/2 + 3b/2", point, expected, gamma(7) * 9.0)?;
        let corners = plot.polyline("parallelogram")?;
        near("the corner is the point", corners[2], point, 0.0)?;
        let sides = (corners[1] - corners[0]) - (corners[2] - corners[3]);
        ensure(sides.amax() <= gamma(4) * 9.0, || {
            format!("opposite sides differ by {sides:?}")
        })
    })
    .rejects("a point that is no affine combination", |plot| {
        plot.shifted("combination", [0.1, 0.0])
    })
    .rejects("a segment that misses a tip", |plot| {
        plot.scaled("convex combinations", 0.9)
    })
    .snapshot();
}

/// The discs have areas in the ratio of the weights, and the levers balance.
#[test]
fn barycentre() {
    figure_test(figures::barycentre(), |plot| {
        let weights = [1.0, 2.0, 5.0];
        let centre = plot.point("G")?;
        let mut moment = Place::origin();
        let (_, unit) = plot.circle("mass 0")?;
        for (i, weight) in weights.into_iter().enumerate() {
            let (middle, radius) = plot.circle(&format!("mass {i}"))?;
            near("a disc", middle, plot.point(&format!("A_{i}"))?, 0.0)?;
            let [from, to] = plot.segment(&format!("lever {i}"))?;
            near("the start of a lever", from, middle, 0.0)?;
            near("the end of a lever", to, centre, 0.0)?;
            // A root, a product and the square: 4 roundings on each side.
            let ratio = radius * radius / (unit * unit);
            ensure((ratio - weight).abs() <= gamma(8) * weight, || {
                format!("the area of disc {i} is {ratio} of the first, not {weight}")
            })?;
            moment += (middle - centre) * weight;
        }
        // The law of barycentres derives 2·3 + 8 roundings of terms up to Σw·2·(1 + 3)·6.
        near(
            "the moment",
            moment,
            Place::origin(),
            gamma(14) * 8.0 * 8.0 * 6.0,
        )
    })
    .rejects("a point that does not balance", |plot| {
        plot.shifted("G", [0.05, 0.0])
    })
    .rejects(
        "a disc whose radius is proportional to the weight",
        |plot| plot.scaled("mass 2", libm::sqrt(5.0)),
    )
    .snapshot();
}
