//! B-splines: piecewise polynomials over a knot vector.
//!
//! - [`basis`] — the uniform B-spline,
//! - [`uniform`] — spline curves with equidistant knots.

pub mod basis;
pub mod uniform;

pub use basis::uniform_b_spline;
pub use uniform::{UniformSpline, UniformSplineError};
