//! Worked numbers of convexity.

use super::Computed;

pub(super) const ALL: &[Computed] = &[];
