//! The numbers of the chapter's worked examples, computed by the library as Markdown.
//!
//! A page shows what a function gives by `{{#computed subdivision NAME}}`.

mod butterfly;
mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod eigenstructure;
mod four_point;
mod kobbelt;
mod limit_points;
mod loop_scheme;
mod meshes;
mod uniform_splines;

use std::ops::RangeInclusive;

use crate::book::tex;
use crate::scalar::BigRational;
use crate::subdivision::CosineError;

/// A function of this chapter by its name.
pub type Computed = (&'static str, fn() -> String);

/// Everything that the pages of the chapter can show.
#[must_use]
pub fn all() -> Vec<Computed> {
    [
        butterfly::ALL,
        catmull_clark::ALL,
        corner_cutting::ALL,
        doo_sabin::ALL,
        eigenstructure::ALL,
        four_point::ALL,
        kobbelt::ALL,
        limit_points::ALL,
        loop_scheme::ALL,
        meshes::ALL,
        uniform_splines::ALL,
    ]
    .concat()
}

/// The valences for which the chapter shows numbers, and for which it tests.
const VALENCES: RangeInclusive<usize> = 3..=12;

/// The fraction where the number is known exactly, four digits after the point otherwise.
fn exact_or_decimal(exact: Option<&BigRational>, decimal: f64) -> String {
    match exact {
        Some(exact) => format!("${}$", tex::fraction(exact)),
        None => format!("${decimal:.4}$"),
    }
}

/// Weights w₀, w₁, … around a vertex with these valences, or a face with so many sides.
///
/// They are symmetric, w₍k₋ⱼ₎ = wⱼ, so that only the first half is shown.
fn star_table(
    name: &str,
    valences: &[usize],
    exact: impl Fn(usize) -> Result<Vec<BigRational>, CosineError>,
    decimal: impl Fn(usize) -> Result<Vec<f64>, CosineError>,
) -> String {
    let half = valences.iter().max().map_or(0, |largest| largest / 2);
    let names: Vec<String> = (0..=half).map(|j| format!("${name}_{j}$")).collect();
    let mut table = format!("| $k$ | {} |\n|--:|", names.join(" | "));
    table += &"--:|".repeat(names.len());
    table += "\n";
    for &k in valences {
        let (exact, decimal) = (exact(k).ok(), decimal(k).unwrap_or_default());
        let cells = (0..=half).map(|j| match decimal.get(j) {
            Some(&weight) if 2 * j <= k => {
                exact_or_decimal(exact.as_ref().and_then(|weights| weights.get(j)), weight)
            }
            _ => String::new(),
        });
        table += &format!("| {k} | {} |\n", cells.collect::<Vec<_>>().join(" | "));
    }
    table
}
