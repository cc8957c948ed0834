//! The weights of Doo and Sabin's scheme by the number of sides of a face.

use super::{Computed, star_table};
use crate::subdivision::doo_sabin_weights;

pub(super) const ALL: &[Computed] = &[("doo_sabin_weights", weights)];

/// The weights γ₀, … of a face with k sides, as far as the symmetry leaves them different.
fn weights() -> String {
    star_table(
        "\\gamma",
        &[3, 4, 5, 6, 7, 8],
        doo_sabin_weights,
        doo_sabin_weights,
    )
}
