//! Worked numbers of barycentric coordinates.

use super::Computed;

pub(super) const ALL: &[Computed] = &[];
