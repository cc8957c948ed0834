//! Subdivision: curves and surfaces as limits of refined polygons and meshes.
//!
//! - [`polygon`] — open and closed polygons, doubling and averaging,
//! - [`laurent`], [`mask`] — schemes for curves, and their algebra,
//! - [`cosine`] — the irrational weights of schemes;
//!
//! the theorems are in [`laws`].

pub mod cosine;
pub mod laurent;
pub mod mask;
pub mod polygon;

mod mesh;
mod scheme;

pub mod laws;

pub use mesh::{
    EdgeId, FaceId, HalfEdgeId, HalfEdgeMesh, Mesh, MeshError, VertexId, VertexRing, solids,
};
pub use scheme::{SchemeError, SurfaceScheme};

#[cfg(feature = "figures")]
pub mod figures;

#[cfg(feature = "book")]
pub mod computed;

pub use cosine::{CosineError, CosineOfTurn};
pub use laurent::LaurentPolynomial;
pub use mask::{Mask, MaskError};
pub use polygon::{Closing, ControlPolygon, ControlPolygonError};
