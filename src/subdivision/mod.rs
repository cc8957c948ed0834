//! Subdivision: curves and surfaces as limits of refined polygons and meshes.
//!
//! The theorems are in [`laws`].

pub mod laws;

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;
