//! Worked numbers of affine combinations.

use super::Computed;

pub(super) const ALL: &[Computed] = &[];
