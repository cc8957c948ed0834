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

/// The figures on combinations and what follows from them.
#[must_use]
pub fn combining() -> Vec<Figure> {
    joined([
        points_and_vectors::all(),
        combinations::all(),
        barycentric::all(),
        convexity::all(),
    ])
}

/// The figures on affine maps and on areas.
#[must_use]
pub fn maps_and_areas() -> Vec<Figure> {
    joined([maps::all(), areas::all()])
}

fn joined<const N: usize>(sections: [Vec<Figure>; N]) -> Vec<Figure> {
    sections.into_iter().flatten().collect()
}
