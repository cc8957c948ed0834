//! The figures of this chapter, one module per section.

mod corner_cutting;
mod uniform_splines;

pub use corner_cutting::*;
pub use uniform_splines::*;

use crate::figure::Figure;

/// All figures of this chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [corner_cutting::all(), uniform_splines::all()]
        .into_iter()
        .flatten()
        .collect()
}
