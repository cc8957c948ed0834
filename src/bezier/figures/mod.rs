//! The figures of this chapter, one module per section.

mod bernstein;
mod blossom;
mod bounds;
mod de_casteljau;
mod derivatives;
mod elevation;
mod representation;
mod shape;
mod subdivision;

pub use bernstein::*;
pub use blossom::*;
pub use bounds::*;
pub use de_casteljau::*;
pub use derivatives::*;
pub use elevation::*;
pub use representation::*;
pub use shape::*;
pub use subdivision::*;

use crate::figure::Figure;

/// All figures of this chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [
        bernstein::all(),
        blossom::all(),
        bounds::all(),
        de_casteljau::all(),
        derivatives::all(),
        elevation::all(),
        representation::all(),
        shape::all(),
        subdivision::all(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
