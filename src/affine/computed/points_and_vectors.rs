//! Worked numbers of points and vectors.

use super::Computed;

pub(super) const ALL: &[Computed] = &[];
