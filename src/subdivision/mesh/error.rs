//! Why lists of faces are not a mesh.

use thiserror::Error;

use super::{FaceId, VertexId};

/// Why vertices and faces do not make a mesh that subdivision can work on.
///
/// Every variant names the element.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{FaceId, HalfEdgeMesh, MeshError, VertexId};
///
/// let refused = |vertices, faces: &[&[u32]]| HalfEdgeMesh::from_faces(vertices, faces).unwrap_err();
///
/// assert_eq!(refused(3, &[]), MeshError::Empty);
/// assert_eq!(refused(3, &[&[0, 1]]), MeshError::FaceTooSmall { face: FaceId(0), degree: 2 });
/// assert!(matches!(refused(3, &[&[0, 1, 3]]), MeshError::DanglingIndex { index: 3, .. }));
/// assert!(matches!(refused(3, &[&[0, 1, 2, 1]]), MeshError::RepeatedVertex { vertex: VertexId(1), .. }));
/// assert_eq!(refused(4, &[&[0, 1, 2]]), MeshError::UnusedVertex { vertex: VertexId(3) });
///
/// // Both triangles run along their common edge from 0 to 1.
/// let error = refused(4, &[&[0, 1, 2], &[0, 1, 3]]);
/// assert!(matches!(error, MeshError::InconsistentOrientation { .. }));
/// assert!(error.to_string().contains("face 0 and face 1"));
///
/// // Three triangles meet in one edge; two triangles touch in one vertex.
/// assert!(matches!(refused(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]), MeshError::NonManifoldEdge { .. }));
/// assert_eq!(
///     refused(5, &[&[0, 1, 2], &[0, 3, 4]]),
///     MeshError::NonManifoldVertex { vertex: VertexId(0), faces: 2, reached: 1 }
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// There is no face.
    #[error("a mesh needs at least one face, found none; give the vertices of a face")]
    Empty,
    /// A face has fewer than three vertices.
    #[error("{face} needs at least 3 vertices, found {degree}; leave it out or complete it")]
    FaceTooSmall {
        /// Which face.
        face: FaceId,
        /// How many vertices it has.
        degree: usize,
    },
    /// A face names a vertex that does not exist.
    #[error(
        "corner {corner} of {face} is vertex {index}, but there are only {vertices} vertices; they are counted from 0"
    )]
    DanglingIndex {
        /// Which face.
        face: FaceId,
        /// Which of its corners, counted from 0.
        corner: usize,
        /// The vertex that it names.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A face passes a vertex twice.
    #[error("{face} passes {vertex} twice; split the face there")]
    RepeatedVertex {
        /// Which face.
        face: FaceId,
        /// Which vertex.
        vertex: VertexId,
    },
    /// A vertex belongs to no face.
    #[error("{vertex} belongs to no face; leave it out")]
    UnusedVertex {
        /// Which vertex.
        vertex: VertexId,
    },
    /// Three faces or more meet in an edge.
    #[error(
        "the edge from {start} to {end} belongs to more than two faces, {} among them; separate the sheets",
        list(faces)
    )]
    NonManifoldEdge {
        /// One end of the edge.
        start: VertexId,
        /// The other end.
        end: VertexId,
        /// Three of the faces.
        faces: [FaceId; 3],
    },
    /// Two neighbouring faces run along their common edge in the same direction.
    #[error(
        "{} and {} both run from {start} to {end}; neighbours must run along their edge in opposite directions, so reverse one",
        faces[0], faces[1]
    )]
    InconsistentOrientation {
        /// Where the edge starts.
        start: VertexId,
        /// Where it ends.
        end: VertexId,
        /// The two faces.
        faces: [FaceId; 2],
    },
    /// The faces around a vertex are not one fan or one ring.
    #[error(
        "the {faces} faces at {vertex} are not connected by edges at it, only {reached} of them are; give each fan a vertex of its own"
    )]
    NonManifoldVertex {
        /// Which vertex.
        vertex: VertexId,
        /// How many faces have it as a corner.
        faces: usize,
        /// How many of them are reached from one by crossing edges at the vertex.
        reached: usize,
    },
    /// There is not one point a vertex.
    #[error("a mesh with {vertices} vertices needs as many points, found {points}")]
    PointCount {
        /// How many vertices there are.
        vertices: usize,
        /// How many points were given.
        points: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("{vertex} is not finite: {point}; every coordinate must be a finite number")]
    NotFinite {
        /// Which vertex.
        vertex: VertexId,
        /// Its point.
        point: String,
    },
    /// A face has another number of vertices than a refinement can split.
    #[error("{face} has {found} vertices, but this refinement splits faces with {expected} only")]
    FaceDegree {
        /// Which face.
        face: FaceId,
        /// The number of vertices that is needed.
        expected: usize,
        /// How many vertices it has.
        found: usize,
    },
    /// There are more elements than numbers of 32 bits.
    #[error(
        "the mesh would have {half_edges} half-edges, but numbers go up to {}; take fewer steps or fewer faces",
        u32::MAX
    )]
    TooLarge {
        /// How many half-edges there would be.
        half_edges: u64,
    },
}

impl MeshError {
    /// The vertices and the faces that the message names.
    pub(super) fn elements_mut(&mut self) -> (Vec<&mut VertexId>, Vec<FaceId>) {
        match self {
            Self::Empty | Self::PointCount { .. } | Self::TooLarge { .. } => (vec![], vec![]),
            Self::FaceTooSmall { face, .. }
            | Self::DanglingIndex { face, .. }
            | Self::FaceDegree { face, .. } => (vec![], vec![*face]),
            Self::RepeatedVertex { face, vertex } => (vec![vertex], vec![*face]),
            Self::UnusedVertex { vertex }
            | Self::NonManifoldVertex { vertex, .. }
            | Self::NotFinite { vertex, .. } => (vec![vertex], vec![]),
            Self::NonManifoldEdge { start, end, faces } => (vec![start, end], faces.to_vec()),
            Self::InconsistentOrientation { start, end, faces } => {
                (vec![start, end], faces.to_vec())
            }
        }
    }
}

fn list(faces: &[FaceId]) -> String {
    let names: Vec<String> = faces.iter().map(ToString::to_string).collect();
    names.join(", ")
}
