//! One law per theorem, lemma, definition and example of the chapter that claims something, in the sections of its text.
//!
//! Bounds for rounding are stated with u = 2⁻⁵³ as in [`law`](crate::law).

mod areas;
mod barycentric;
mod combinations;
mod convexity;
mod magnitudes;
mod maps;
mod points_and_vectors;

pub use areas::*;
pub use convexity::*;
pub use maps::*;
