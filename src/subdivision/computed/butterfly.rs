//! The weights of the modified Butterfly scheme by valence.

use super::{Computed, star_table};
use crate::subdivision::butterfly_star_weights;

pub(super) const ALL: &[Computed] = &[("butterfly_star", butterfly_star)];

/// The weights s₀, … of the neighbours of a vertex of valence k, as far as the symmetry leaves them different.
fn butterfly_star() -> String {
    // At valence 6 the eight points count.
    star_table(
        "s",
        &[3, 4, 5, 7, 8],
        butterfly_star_weights,
        butterfly_star_weights,
    )
}
