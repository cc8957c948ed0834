//! Worked numbers of affine maps.

use super::Computed;

pub(super) const ALL: &[Computed] = &[];
