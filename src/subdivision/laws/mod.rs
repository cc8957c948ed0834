//! One law per theorem, lemma, algorithm and example of the chapter that claims something, in the sections of its text.
//!
//! Bounds for rounding are stated with u = 2⁻⁵³ as in [`law`](crate::law).

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
