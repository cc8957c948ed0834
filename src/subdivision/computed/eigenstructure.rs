//! The eigenvalues of the subdivision matrices and the tests of the characteristic maps, by valence.

use super::{Computed, VALENCES};
use crate::scalar::Scalar as _;
use crate::subdivision::figures::{Chosen, SCHEMES};
use crate::subdivision::{
    CharacteristicMap, FanNet, Spectrum, SubdivisionMatrix, SubdivisionMatrixError,
};

pub(super) const ALL: &[Computed] = &[
    ("subdominant_eigenvalues", subdominant_eigenvalues),
    ("third_eigenvalues", third_eigenvalues),
    ("characteristic_tests", characteristic_tests),
];

/// The heads of the columns, in the order of the schemes.
const NAMES: [&str; 6] = [
    "Loop",
    "Butterfly",
    "Catmull–Clark",
    "Doo–Sabin",
    "Kobbelt",
    "eight points",
];

/// A table with a row for each valence and a column for each of the first `columns` schemes.
///
/// A cell is told the scheme, its net, the valence and the rings of its smallest matrix.
fn table(
    columns: usize,
    cell: impl Fn(Chosen, FanNet, usize, usize) -> Result<String, SubdivisionMatrixError>,
) -> String {
    let mut table = format!("| $k$ | {} |\n|--:|", NAMES[..columns].join(" | "));
    table += &"--:|".repeat(columns);
    table += "\n";
    for k in VALENCES {
        let cells = SCHEMES[..columns].iter().map(|&(scheme, net, rings)| {
            cell(scheme, net, k, rings).unwrap_or_else(|_| "none".to_string())
        });
        table += &format!("| {k} | {} |\n", cells.collect::<Vec<_>>().join(" | "));
    }
    table
}

/// The absolute values of the eigenvalues with this place in the order of size, without those of the eight-point scheme.
fn absolute_values(place: usize) -> String {
    table(5, |scheme, net, valence, rings| {
        let matrix = SubdivisionMatrix::extract(&scheme, net, valence, rings)?;
        let value = Spectrum::of(&matrix).eigenvalues()[place].value;
        // Multiple eigenvalues with a Jordan block are found with half of the digits.
        Ok(format!("{:.3}", value.magnitude()))
    })
}

/// λ₁ = λ₂.
fn subdominant_eigenvalues() -> String {
    absolute_values(1)
}

/// |λ₃|.
fn third_eigenvalues() -> String {
    absolute_values(3)
}

/// Whether the characteristic map passes its test after one step, and why not.
fn characteristic_tests() -> String {
    table(6, |scheme, net, valence, _rings| {
        let test = CharacteristicMap::of(&scheme, net, valence)?.test(&scheme, 1)?;
        Ok(if test.passed() {
            "passes".to_string()
        } else if !test.subdominant_pair {
            "no pair".to_string()
        } else if test.winding_number != 1 {
            format!("winds {}×", test.winding_number)
        } else {
            "turns over".to_string()
        })
    })
}
