//! Affine geometry: points are not vectors.
//!
//! Read in this order: [`point`] (positions and displacements), [`combination`] (which sums of points
//! are points), [`interval`] (the parameter domain), [`map`] (what keeps combinations),
//! [`hull`] (convexity).

pub mod combination;
pub mod interval;
pub mod point;

pub use combination::{Affine, CombinationError, Linear};
pub use interval::{Interval, IntervalError};
pub use point::{Point, Vector};
