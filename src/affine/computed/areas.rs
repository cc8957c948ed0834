//! Worked numbers of areas.

use super::Computed;

pub(super) const ALL: &[Computed] = &[];
