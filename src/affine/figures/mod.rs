//! The figures of this chapter, one module per section.

mod areas;
mod barycentric;
mod combinations;
mod convexity;
mod maps;
mod points_and_vectors;

pub use areas::*;
pub use barycentric::*;
pub use combinations::*;
pub use convexity::*;
pub use maps::*;

use crate::figure::Figure;

/// All figures of this chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [
        areas::all(),
        barycentric::all(),
        combinations::all(),
        convexity::all(),
        maps::all(),
        points_and_vectors::all(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
