//! The figures of this chapter, one module per section.

mod blossom;
mod de_casteljau;
mod elevation;
mod shape;

pub use blossom::*;
pub use de_casteljau::*;
pub use elevation::*;
pub use shape::*;

use crate::figure::Figure;

/// All figures of this chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [
        blossom::all(),
        de_casteljau::all(),
        elevation::all(),
        shape::all(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
