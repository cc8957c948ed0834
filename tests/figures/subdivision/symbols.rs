//! Figures of the section on masks and symbols.

use cagd::subdivision::figures;

use crate::support::{ensure, figure_test};

/// Two schemes have the same bound, which is drawn once.
const BOTH: &str = "bound: Chaikin and cubic";

/// No polygon moves farther than the bound says, and the bounds of Chaikin halve in every step.
#[test]
fn difference_scheme() {
    figure_test(figures::difference_scheme(), |plot| {
        for (name, bound) in [
            ("Chaikin", BOTH),
            ("cubic", BOTH),
            ("four-point", "bound: four-point"),
        ] {
            let moved = plot.points(name)?;
            let bound = plot.polyline(bound)?;
            ensure(moved.len() == 8 && bound.len() == 8, || {
                format!("{name}: eight steps")
            })?;
            for (moved, bound) in moved.iter().zip(bound) {
                // Both numbers are sums of a few dyadic fractions, exact in f64 for so few steps.
                ensure(moved[0] == bound[0] && moved[1] <= bound[1], || {
                    format!("{name}: {moved} above {bound}")
                })?;
                ensure(moved[1] > 0.0, || {
                    format!("{name}: {moved} has no logarithm")
                })?;
            }
        }
        let chaikin = plot.polyline(BOTH)?;
        ensure(chaikin[0][1] == 0.25, || {
            format!("the first bound is {}", chaikin[0])
        })?;
        ensure(
            chaikin
                .windows(2)
                .all(|pair| pair[1][1] == pair[0][1] / 2.0),
            || "the bounds of Chaikin do not halve".into(),
        )
    })
    .rejects("a polygon that moves too far", |plot| {
        plot.shifted("cubic", [0.0, 0.2])
    })
    .rejects("another bound", |plot| plot.shifted(BOTH, [0.0, 0.1]))
    .snapshot();
}
