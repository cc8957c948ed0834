//! Affine geometry: points are not vectors.
//!
//! Read in this order: [`point`] (positions and displacements), [`combination`] (which sums of points
//! are points), [`interval`] (the parameter domain), [`barycentric`] (coordinates in a simplex),
//! [`map`] (what keeps combinations), [`hyperplane`] (lines and planes),
//! [`orientation`] (left or right of a line), [`hull`] (convexity), [`bounding_box`] (boxes along the axes);
//! the theorems are in [`laws`].

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

pub mod laws;

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;

pub use barycentric::{AffineBasis, AffineBasisError};
pub use bounding_box::{BoundingBox, BoundingBoxError};
pub use combination::{Affine, CombinationError, Linear};
pub use hull::{ConvexHull, HullCost, HullError};
pub use hyperplane::{Hyperplane, HyperplaneError, Line};
pub use interval::{Interval, IntervalError};
pub use map::{AffineMap, AffineMapError};
pub use orientation::{Orient, Turn};
pub use point::{Point, Vector};

/// The chapter's pages, so that `cargo test` runs each of their Rust blocks.
#[cfg(doctest)]
mod chapter {
    #[doc = include_str!("../../book/src/affine/points-and-vectors.md")]
    mod points_and_vectors {}
    #[doc = include_str!("../../book/src/affine/combinations.md")]
    mod combinations {}
    #[doc = include_str!("../../book/src/affine/barycentric.md")]
    mod barycentric {}
    #[doc = include_str!("../../book/src/affine/maps.md")]
    mod maps {}
    #[doc = include_str!("../../book/src/affine/convexity.md")]
    mod convexity {}
    #[doc = include_str!("../../book/src/affine/areas.md")]
    mod areas {}
}
