//! Affine geometry: points are not vectors.
//!
//! Read in this order: [`point`] (positions and displacements), [`combination`] (which sums of points
//! are points), [`combination_kind`] (linear, affine, convex), [`origin`] (what depends on the origin),
//! [`mod@barycentre`] (where weighted points balance), [`interval`] (the parameter domain),
//! [`mod@line_coordinates`] (coordinates on a line), [`barycentric`] (coordinates in a simplex),
//! [`frame`] (a point and vectors), [`map`] (what keeps combinations), [`hyperplane`] (lines and planes),
//! [`standard_maps`] (rotations, shears and their kind), [`projection`] (from a point: not affine),
//! [`orientation`] (left or right of a line), [`hull`] (convexity), [`bounding_box`] (boxes along the axes),
//! [`triangle`] (signed areas), [`polygon`] (simple polygons), [`lattice`] (polygons with whole coordinates),
//! [`monte_carlo`](mod@monte_carlo) (areas by chance);
//! the theorems are in [`laws`].

pub mod barycentre;
pub mod barycentric;
pub mod bounding_box;
pub mod combination;
pub mod combination_kind;
mod elimination;
pub mod frame;
pub mod hull;
pub mod hyperplane;
pub mod interval;
pub mod lattice;
pub mod line_coordinates;
pub mod map;
pub mod monte_carlo;
pub mod orientation;
pub mod origin;
pub mod point;
pub mod polygon;
pub mod projection;
mod segment;
pub mod standard_maps;
pub mod triangle;

pub mod laws;

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;

pub use barycentre::barycentre;
pub use barycentric::{AffineBasis, AffineBasisError};
pub use bounding_box::{BoundingBox, BoundingBoxError};
pub(crate) use combination::sums_to;
pub use combination::{Affine, CombinationError, Linear};
pub use combination_kind::CombinationKind;
pub use frame::Frame;
pub use hull::{ConvexHull, HullCost, HullError};
pub use hyperplane::{Hyperplane, HyperplaneError, Line};
pub use interval::{Interval, IntervalError};
pub use lattice::{LatticeCount, LatticePoint, LatticePolygon, LatticePolygonError};
pub use line_coordinates::{LineCoordinatesError, line_coordinates};
pub use map::{AffineMap, AffineMapError};
pub use monte_carlo::{MonteCarloError, MonteCarloEstimate, UniformPoints, monte_carlo};
pub use orientation::{Orient, Turn};
pub use origin::{point_seen_from, vector_seen_from};
pub use point::{Point, Vector};
pub use polygon::{Location, PolygonError, SimplePolygon};
pub use projection::{CentralProjection, CentralProjectionError};
pub use standard_maps::ParallelProjectionError;
pub use triangle::{plane_determinant, signed_area};

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
