//! Affine geometry: points are not vectors.
//!
//! Read in this order: [`point`] (positions and displacements), [`combination`] (which sums of points
//! are points), [`interval`] (the parameter domain), [`barycentric`] (coordinates in a simplex),
//! [`map`] (what keeps combinations), [`hyperplane`] (lines and planes),
//! [`orientation`] (left or right of a line), [`hull`] (convexity), [`bounding_box`] (boxes along the axes).

pub mod barycentric;
pub mod bounding_box;
pub mod combination;
mod elimination;
pub mod hull;
pub mod hyperplane;
pub mod interval;
pub mod map;
pub mod orientation;
pub mod point;

pub use barycentric::{AffineBasis, AffineBasisError};
pub use bounding_box::{BoundingBox, BoundingBoxError};
pub use combination::{Affine, CombinationError, Linear};
pub use hull::{ConvexHull, HullCost, HullError};
pub use hyperplane::{Hyperplane, HyperplaneError, Line};
pub use interval::{Interval, IntervalError};
pub use map::{AffineMap, AffineMapError};
pub use orientation::{Orient, Turn};
pub use point::{Point, Vector};
