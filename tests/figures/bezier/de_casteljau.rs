//! Figures of the section on the algorithm of de Casteljau.

use cagd::affine::Affine;
use cagd::bezier::figures;

use crate::support::{ensure, figure_test, near};

/// Each level divides the segments of the one before in the ratio t : (1 − t), and the last point is on the curve.
#[test]
fn figure_de_casteljau() {
    figure_test(figures::figure_de_casteljau(), |plot| {
        let t = 0.4;
        for n in 2..=4 {
            let item = |name: &str| format!("n = {n}/{name}");
            let mut level = plot.polyline(&item("control polygon"))?.to_vec();
            ensure(level.len() == n + 1, || {
                format!("degree {n} has {} control points", level.len())
            })?;
            for j in 1..=n {
                level = level
                    .windows(2)
                    .map(|pair| pair[0].lerp(&pair[1], t))
                    .collect();
                if j < n {
                    let drawn = plot.polyline(&item(&format!("level {j}")))?;
                    ensure(drawn == level, || {
                        format!("n = {n}: level {j} is {drawn:?}, expected {level:?}")
                    })?;
                }
            }
            // Drawn and computed here by the same operations in the same order: no rounding separates them.
            near("b(t)", plot.point(&item("b(t)"))?, level[0], 0.0)?;
            let on_curve = plot.samples(&item("curve"))?.find(|(s, _)| *s == t);
            ensure(on_curve.is_some_and(|(_, p)| p == level[0]), || {
                format!("n = {n}: b(t) is not on the curve")
            })?;
        }
        Ok(())
    })
    .rejects("a point of division that is off its segment", |plot| {
        plot.shifted("n = 3/level 2", [0.0, 0.05])
    })
    .rejects("a curve that misses b(t)", |plot| {
        plot.shifted("n = 4/curve", [0.05, 0.0])
    })
    .snapshot();
}
