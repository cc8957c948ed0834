//! Meshes: connectivity as half-edges, and points.

mod connectivity;
mod construction;
mod error;
pub mod files;
mod geometry;
mod id;
mod refinement;
pub mod solids;
mod split;
mod tables;
mod traversal;

pub use connectivity::HalfEdgeMesh;
pub use error::MeshError;
pub use geometry::Mesh;
pub use id::{EdgeId, FaceId, HalfEdgeId, VertexId};
pub use refinement::Refinement;
pub(super) use split::prev_in_triangle;
pub use tables::HalfEdgeTables;
pub use traversal::VertexRing;
