//! Subdivision: curves and surfaces as limits of refined polygons and meshes.
//!
//! - [`cosine`] — the irrational weights of schemes,
//! - [`polygon`] — open and closed polygons, doubling and averaging;
//!
//! the theorems are in [`laws`].

pub mod cosine;
pub mod polygon;

pub mod laws;

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;

pub use cosine::{CosineError, CosineOfTurn};
pub use polygon::{Closing, ControlPolygon, ControlPolygonError};
