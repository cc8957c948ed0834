//! The limit weights and the eigenvalue of Catmull and Clark's scheme by valence.

use super::{Computed, VALENCES};
use crate::book::tex;
use crate::scalar::BigRational;
use crate::subdivision::{catmull_clark_limit_weights, catmull_clark_tangent_factor};

pub(super) const ALL: &[Computed] = &[("catmull_clark_limit", catmull_clark_limit)];

/// The weights of the limit position, the factor A of the tangents and λ = (A + 4)/16.
fn catmull_clark_limit() -> String {
    let mut table = String::from(
        "| $k$ | $v$ | each $e_j$ | each $f_j$ | $A$ | $\\lambda$ |\n|--:|--:|--:|--:|--:|--:|\n",
    );
    for valence in VALENCES {
        let weights = catmull_clark_limit_weights::<BigRational>(valence);
        let weights = weights.map(|weight| format!("${}$", tex::fraction(&weight)));
        let factor = catmull_clark_tangent_factor::<f64>(valence);
        table += &format!(
            "| {valence} | {} | {factor:.4} | {:.4} |\n",
            weights.join(" | "),
            (factor + 4.0) / 16.0
        );
    }
    table
}
