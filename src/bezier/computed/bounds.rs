//! Worked numbers of the distance bounds.

use super::Computed;
use crate::affine::Point;
use crate::bezier::BezierCurve;
use crate::bezier::bounds::{chord_factor, control_polygon_factor, euclidean_norm};
use crate::book::tex;
use crate::scalar::BigRational;

pub(super) const ALL: &[Computed] = &[
    ("bound_factors", bound_factors),
    ("subdivision_depths", subdivision_depths),
];

/// Both factors for the degrees 2 to 8.
fn bound_factors() -> String {
    let degrees = 2..=8;
    let row = |name: &str, entry: &dyn Fn(usize) -> String| {
        let entries: Vec<String> = degrees.clone().map(entry).collect();
        format!("| {name} | {} |\n", entries.join(" | "))
    };
    let rule = format!("|{}\n", "---|".repeat(degrees.clone().count() + 1));
    row("degree $n$", &|n| n.to_string())
        + &rule
        + &row("chord, $\\frac{n(n-1)}8$", &|n| {
            format!("${}$", tex::fraction(&chord_factor::<BigRational>(n)))
        })
        + &row("polygon, $N_\\infty(n)$", &|n| {
            format!(
                "${}$",
                tex::fraction(&control_polygon_factor::<BigRational>(n))
            )
        })
}

/// How often to halve a cubic, and how many chords flattening takes.
fn subdivision_depths() -> String {
    let points = [[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new);
    let curve = BezierCurve::new(points).expect("four points");
    let mut table = String::from(
        "| $\\varepsilon$ | halvings $k$ | pieces $2^k$ | chords of equal parameter length | chords of adapted length |\n|---|---|---|---|---|\n",
    );
    for power in 0..=5 {
        let tolerance = 10f64.powi(-power);
        let steps = curve
            .subdivision_depth(&tolerance, euclidean_norm)
            .expect("a tolerance");
        let uniform = curve.uniform_chord_count(tolerance).expect("a tolerance");
        let adapted = curve.flattened(tolerance).expect("a tolerance").chords();
        table += &format!(
            "| $10^{{{}}}$ | {steps} | {} | {uniform} | {adapted} |\n",
            -power,
            1usize << steps
        );
    }
    table
}
