//! The figures of this chapter, one module per section.

mod de_casteljau;

pub use de_casteljau::*;

use crate::figure::Figure;

/// All figures of this chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [de_casteljau::all()].into_iter().flatten().collect()
}
