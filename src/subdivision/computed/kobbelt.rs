//! The weights of Kobbelt's virtual point by valence.

use super::Computed;
use crate::book::tex;
use crate::scalar::BigRational;
use crate::subdivision::kobbelt_virtual_weights;

pub(super) const ALL: &[Computed] = &[("kobbelt_virtual_point", kobbelt_virtual_point)];

/// The weights of the neighbours and of the opposite vertices, beginning with those of the edge.
fn kobbelt_virtual_point() -> String {
    let mut table =
        String::from("| $n$ | $l_i, l_{i+1}, \\dots$ | $q_i, q_{i+1}, \\dots$ |\n|--:|---|---|\n");
    for valence in 3..=6 {
        let lists = kobbelt_virtual_weights::<BigRational>(valence).map(|weights| {
            let weights: Vec<String> = weights.iter().map(tex::fraction).collect();
            format!("${}$", weights.join(", "))
        });
        table += &format!("| {valence} | {} |\n", lists.join(" | "));
    }
    table
}
