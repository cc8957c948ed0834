//! Bézier curves.
//!
//! Read in this order:
//!
//! - [`curve`]: control points and domain,
//! - [`casteljau`]: evaluation and its triangle,
//! - [`bernstein`](mod@bernstein): the basis,
//! - [`evaluation`]: evaluation in linear time,
//! - [`derivative`]: hodographs,
//! - [`bounding_box`], [`hull`]: where the curve lies,
//! - [`subdivision`]: pieces of a curve, and corner cutting,
//! - [`bounds`]: how far a curve is from its chord and its control polygon,
//! - [`elevation`]: more control points, the same curve,
//! - [`approximation`]: Bernstein approximation;
//!
//! the theorems are in [`laws`].

pub mod approximation;
pub mod bernstein;
pub mod bounding_box;
pub mod bounds;
pub mod casteljau;
pub mod curve;
pub mod derivative;
pub mod elevation;
pub mod evaluation;
pub mod hull;
pub mod subdivision;

pub mod laws;

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;

pub use approximation::polygon_at;
pub use bernstein::{bernstein, binomial};
pub use casteljau::CasteljauTriangle;
pub use curve::{BezierCurve, BezierError, Hodograph, PlaneCurve};
pub use elevation::ReductionError;
pub use subdivision::{CornerCutting, SubdividedPolygon};
