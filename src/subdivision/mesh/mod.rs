//! Meshes: connectivity as half-edges, and points.

mod connectivity;
mod construction;
mod error;
mod geometry;
mod id;
pub mod solids;
mod split;
mod traversal;

pub use connectivity::HalfEdgeMesh;
pub use error::MeshError;
pub use geometry::Mesh;
pub use id::{EdgeId, FaceId, HalfEdgeId, VertexId};
pub use traversal::VertexRing;
