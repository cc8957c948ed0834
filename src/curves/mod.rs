//! What holds for any parametric curve.
//!
//! Read in this order: [`parametric`] (what a curve is: a domain, points, derivative vectors),
//! [`curvature`] (in the plane with a sign, in space, and torsion), [`osculating_circle`],
//! [`quadrature`] and [`arc_length`] (with its inverse), [`sampling`] (polylines).

pub mod arc_length;
pub mod curvature;
pub mod osculating_circle;
pub mod parametric;
pub mod quadrature;
pub mod sampling;

pub(crate) mod range;

pub use arc_length::{ArcLength, ArcLengthError, Certainty, Rectifiable};
pub use curvature::{CurvatureError, PlaneCurvature, SpaceCurvature};
pub use osculating_circle::OsculatingCircle;
pub use parametric::ParametricCurve;
pub use quadrature::GaussLegendre;
pub use sampling::polyline;
