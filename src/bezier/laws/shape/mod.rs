//! Laws of the shape of Bézier curves.

mod intersections;
mod invariance;
mod regions;

pub use intersections::*;
pub use invariance::*;
pub use regions::*;
