//! Worked numbers of blossoms.

use super::Computed;
use crate::affine::Interval;
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[(
    "control_points_over_intervals",
    control_points_over_intervals,
)];

/// The Bézier points of the cubic of the worked examples over several intervals.
fn control_points_over_intervals() -> String {
    let cubic = super::de_casteljau::curve([[0, 0], [0, 4], [4, 4], [4, 0]]);
    let blossom = cubic.blossom();
    let mut table = String::from(
        "| $[a,b]$ | $p(a,a,a)$ | $p(a,a,b)$ | $p(a,b,b)$ | $p(b,b,b)$ |\n|---|---|---|---|---|\n",
    );
    for quarters in [[0, 4], [0, 2], [2, 4], [1, 3], [-4, 4], [4, 8]] {
        let [a, b] = quarters.map(|q| BigRational::from_ratio(q, 4));
        let interval = Interval::new(a.clone(), b.clone()).expect("two different ends");
        table += &format!("| $[{}, {}]$ |", tex::fraction(&a), tex::fraction(&b));
        for point in blossom.control_points_on(&interval) {
            table += &format!(" ${}$ |", tex::point(&point, tex::fraction));
        }
        table.push('\n');
    }
    table
}
