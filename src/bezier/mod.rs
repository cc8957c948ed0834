//! Bézier curves.
//!
//! Read in this order: [`curve`] (control points and domain), [`casteljau`] (evaluation and its
//! triangle), [`bernstein`](mod@bernstein) (the basis), [`derivative`] (hodographs); the theorems are in [`laws`].

pub mod bernstein;
pub mod casteljau;
pub mod curve;
pub mod derivative;

pub mod laws;

pub use bernstein::{bernstein, binomial};
pub use casteljau::CasteljauTriangle;
pub use curve::{BezierCurve, BezierError, Hodograph, PlaneCurve};
