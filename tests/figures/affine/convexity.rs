//! Figures of the section on convexity.

use cagd::affine::{Affine, Point, SimplePolygon, figures};
use cagd::figure::{BoxError, Plot};

use crate::support::{ensure, figure_test};

/// Whether the set of a panel is convex, and which of 1000 points of its segment lie outside.
fn outside(plot: &Plot, panel: &str) -> Result<(bool, Vec<f64>), BoxError> {
    let set = SimplePolygon::new(plot.polygon(&format!("{panel}/set"))?.iter().copied())?;
    let [p, q] = plot.segment(&format!("{panel}/segment"))?;
    ensure(set.contains(&p) && set.contains(&q), || {
        format!("{panel}: an end is outside")
    })?;
    let steps = (0..=1000).map(|k| f64::from(k) / 1000.0);
    let missing = steps.filter(|t| !set.contains(&p.lerp(&q, *t))).collect();
    Ok((set.is_convex(), missing))
}

/// The segment of the convex set stays inside. That of the other one leaves it exactly where the dashed part is.
///
/// The ends of that part are known to one step in 1000 of a segment shorter than 3.
#[test]
fn figure_convex() {
    figure_test(figures::figure_convex(), |plot| {
        let (is_convex, missing) = outside(plot, "convex")?;
        ensure(is_convex && missing.is_empty(), || {
            "the first set is not convex".into()
        })?;
        let marked = plot
            .names()
            .filter(|(_, name)| name.starts_with("outside"))
            .count();
        ensure(marked == 1, || format!("{marked} parts are marked"))?;
        let (is_convex, missing) = outside(plot, "not convex")?;
        ensure(!is_convex, || "the second set is convex".into())?;
        let [p, q] = plot.segment("not convex/segment")?;
        let ends = [missing.first(), missing.last()].map(|t| p.lerp(&q, *t.unwrap_or(&0.0)));
        let part = plot.segment("outside 0")?;
        let gap = std::iter::zip(part, ends)
            .map(|(a, b)| (a - b).norm())
            .fold(0.0, f64::max);
        ensure(gap <= 3.0 / 1000.0, || {
            format!("the part outside is off by {gap}")
        })
    })
    .rejects("a part outside that is too short", |plot| {
        plot.scaled("outside 0", 0.8)
    })
    .rejects("a segment that leaves the convex set", |plot| {
        plot.shifted("convex/segment", [0.0, 1.2])
    })
    .rejects("the sets exchanged", |plot| {
        plot.swapped("convex/set", "not convex/set")
    })
    .rejects("a segment of a single place", |plot| {
        plot.replaced("not convex/segment", [Point::new([0.0, -1.5]); 2])
    })
    .snapshot();
}
