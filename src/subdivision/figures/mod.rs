//! The figures of this chapter, one module per section.

mod butterfly;
mod catmull_clark;
mod corner_cutting;
mod doo_sabin;
mod eigenstructure;
mod four_point;
mod kobbelt;
mod limit_points;
mod loop_scheme;
mod meshes;
mod symbols;
mod uniform_splines;

pub use butterfly::*;
pub use catmull_clark::*;
pub use corner_cutting::*;
pub use doo_sabin::*;
pub use eigenstructure::*;
pub use four_point::*;
pub use kobbelt::*;
pub use limit_points::*;
pub use loop_scheme::*;
pub use meshes::*;
pub use symbols::*;
pub use uniform_splines::*;

use crate::figure::Figure;

/// All figures of this chapter.
#[must_use]
pub fn all() -> Vec<Figure> {
    [
        butterfly::all(),
        catmull_clark::all(),
        corner_cutting::all(),
        doo_sabin::all(),
        eigenstructure::all(),
        four_point::all(),
        kobbelt::all(),
        limit_points::all(),
        loop_scheme::all(),
        meshes::all(),
        symbols::all(),
        uniform_splines::all(),
    ]
    .into_iter()
    .flatten()
    .collect()
}
