//! Bézier curves.
//!
//! Read in this order: [`curve`] (control points and domain), [`casteljau`] (evaluation and its
//! triangle), [`derivative`] (hodographs); the theorems are in [`laws`].

pub mod casteljau;
pub mod curve;
pub mod derivative;
pub mod laws;

pub use casteljau::CasteljauTriangle;
pub use curve::{BezierCurve, BezierError};
