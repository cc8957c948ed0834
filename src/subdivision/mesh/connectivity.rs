//! The half-edge mesh: which vertices, edges and faces meet, and nothing of where they are.

use super::{EdgeId, FaceId, HalfEdgeId, VertexId};

/// The connectivity of an orientable surface with or without boundary, as half-edges.
///
/// A **half-edge** is one side of an edge with a direction: it runs from its [`origin`](Self::origin) along the edge,
/// its face to the left.
///
/// ```text
///              next(h)
///         ●◀──────────●
///         ╎   face    ▲│           flip(flip(h)) = h ≠ flip(h)
///         ╎   of h   h││flip(h)    next(prev(h)) = h = prev(next(h))
///         ╎           │▼           origin(flip(h)) = origin(next(h))
///         ●──────────▶●            edge(h) = edge(flip(h))
///  origin(prev(h))   origin(h)     flip(prev(h)) is the next half-edge around origin(h)
/// ```
///
/// The half-edges along a boundary have no face; `next` leads them along their boundary loop.
///
/// # Numbers
///
/// The half-edges of a face have consecutive numbers, in the order of its vertices, and the faces follow each other.
/// So `next`, `prev` and `face` need no memory where all faces have the same number of vertices.
/// The half-edges of the boundary come after all others.
///
/// # Invariants
///
/// [`from_faces`](Self::from_faces) checks that the lists describe a manifold whose faces are oriented consistently;
/// all equations above hold for every value of this type.
///
/// # Examples
///
/// Two triangles with a common edge:
///
/// ```
/// use cagd::subdivision::{HalfEdgeId, HalfEdgeMesh, VertexId};
///
/// let mesh = HalfEdgeMesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?;
/// assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.face_count()), (4, 5, 2));
///
/// let h = HalfEdgeId(1);
/// assert_eq!((mesh.origin(h), mesh.destination(h)), (VertexId(1), VertexId(2)));
/// assert_eq!(mesh.flip(h), HalfEdgeId(3));
/// assert_eq!(mesh.flip(mesh.flip(h)), h);
/// assert_eq!(mesh.boundary_loops().len(), 1);
/// # Ok::<(), cagd::subdivision::MeshError>(())
/// ```
///
/// A vertex is not a half-edge, so it has no flip:
///
/// ```compile_fail,E0308
/// # use cagd::subdivision::{HalfEdgeMesh, VertexId};
/// # let mesh = HalfEdgeMesh::from_faces(3, &[[0, 1, 2]]).unwrap();
/// let flip = mesh.flip(VertexId(0));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HalfEdgeMesh {
    /// The faces' half-edges, in blocks.
    pub(in crate::subdivision) blocks: Blocks,
    /// Of every half-edge: the vertex where it starts.
    pub(in crate::subdivision) origin: Vec<u32>,
    /// Of every half-edge: the other half of its edge.
    pub(in crate::subdivision) flip: Vec<u32>,
    /// Of every half-edge: its edge.
    pub(in crate::subdivision) edge: Vec<u32>,
    /// Of every boundary half-edge, counted from the first of them: the next one along the boundary.
    pub(in crate::subdivision) boundary_next: Vec<u32>,
    /// Of every boundary half-edge, counted from the first of them: the one before along the boundary.
    pub(in crate::subdivision) boundary_prev: Vec<u32>,
    /// Of every vertex: a half-edge that starts there, at the boundary the one without face.
    pub(in crate::subdivision) vertex_half_edge: Vec<u32>,
    /// Of every edge: its half-edge with the smaller number, which has a face.
    pub(in crate::subdivision) edge_half_edge: Vec<u32>,
}

/// Which half-edges belong to which face.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::subdivision) enum Blocks {
    /// All faces have the same number of vertices.
    Uniform {
        /// How many vertices a face has.
        degree: u32,
        /// How many faces there are.
        faces: u32,
    },
    /// Faces with different numbers of vertices.
    Mixed {
        /// Of every face its first half-edge, and behind them the number of all half-edges with a face.
        first: Vec<u32>,
        /// Of every half-edge its face.
        face: Vec<u32>,
    },
}

impl Blocks {
    /// How many half-edges have a face.
    pub(in crate::subdivision) fn half_edges(&self) -> usize {
        match self {
            Self::Uniform { degree, faces } => *degree as usize * *faces as usize,
            Self::Mixed { face, .. } => face.len(),
        }
    }

    pub(in crate::subdivision) fn faces(&self) -> usize {
        match self {
            Self::Uniform { faces, .. } => *faces as usize,
            Self::Mixed { first, .. } => first.len() - 1,
        }
    }

    /// The first half-edge of a face, and the first that is not its any more.
    pub(super) fn range(&self, face: u32) -> std::ops::Range<u32> {
        match self {
            Self::Uniform { degree, .. } => face * degree..(face + 1) * degree,
            Self::Mixed { first, .. } => first[face as usize]..first[face as usize + 1],
        }
    }

    pub(in crate::subdivision) fn face(&self, half_edge: u32) -> u32 {
        match self {
            Self::Uniform { degree, .. } => half_edge / degree,
            Self::Mixed { face, .. } => face[half_edge as usize],
        }
    }
}

/// The elements and their numbers.
impl HalfEdgeMesh {
    /// How many vertices there are.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_half_edge.len()
    }

    /// How many edges there are.
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.edge_half_edge.len()
    }

    /// How many faces there are.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.blocks.faces()
    }

    /// How many half-edges there are, two an edge.
    #[must_use]
    pub fn half_edge_count(&self) -> usize {
        self.origin.len()
    }

    /// How many half-edges have a face: the sum of the numbers of vertices of all faces.
    #[must_use]
    pub fn corner_count(&self) -> usize {
        self.blocks.half_edges()
    }

    /// All vertices, by number.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + use<> {
        (0..self.vertex_count()).map(VertexId::at)
    }

    /// All edges, by number.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = EdgeId> + use<> {
        (0..self.edge_count()).map(EdgeId::at)
    }

    /// All faces, by number.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = FaceId> + use<> {
        (0..self.face_count()).map(FaceId::at)
    }

    /// All half-edges, by number.
    pub fn half_edges(&self) -> impl ExactSizeIterator<Item = HalfEdgeId> + use<> {
        (0..self.half_edge_count()).map(HalfEdgeId::at)
    }
}

/// What every element knows of its neighbours.
///
/// A number that is not one of this mesh makes these functions panic, like the index of a list.
impl HalfEdgeMesh {
    /// The other half of the edge.
    #[must_use]
    #[inline]
    pub fn flip(&self, h: HalfEdgeId) -> HalfEdgeId {
        HalfEdgeId(self.flip[h.index()])
    }

    /// The next half-edge around the face, at the boundary along it.
    #[must_use]
    #[inline]
    pub fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        match h.index().checked_sub(self.corner_count()) {
            Some(at_boundary) => HalfEdgeId(self.boundary_next[at_boundary]),
            None => {
                let block = self.blocks.range(self.blocks.face(h.0));
                let after = h.0 + 1;
                HalfEdgeId(if after == block.end {
                    block.start
                } else {
                    after
                })
            }
        }
    }

    /// The half-edge before this one around the face, at the boundary along it.
    #[must_use]
    #[inline]
    pub fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        match h.index().checked_sub(self.corner_count()) {
            Some(at_boundary) => HalfEdgeId(self.boundary_prev[at_boundary]),
            None => {
                let block = self.blocks.range(self.blocks.face(h.0));
                HalfEdgeId(if h.0 == block.start { block.end } else { h.0 } - 1)
            }
        }
    }

    /// The vertex where a half-edge starts.
    #[must_use]
    #[inline]
    pub fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId(self.origin[h.index()])
    }

    /// The vertex where a half-edge ends.
    #[must_use]
    #[inline]
    pub fn destination(&self, h: HalfEdgeId) -> VertexId {
        self.origin(self.flip(h))
    }

    /// The edge of a half-edge.
    #[must_use]
    #[inline]
    pub fn edge(&self, h: HalfEdgeId) -> EdgeId {
        EdgeId(self.edge[h.index()])
    }

    /// The face to the left of a half-edge; none along the boundary.
    #[must_use]
    #[inline]
    pub fn face(&self, h: HalfEdgeId) -> Option<FaceId> {
        (h.index() < self.corner_count()).then(|| FaceId(self.blocks.face(h.0)))
    }

    /// A half-edge that starts at a vertex; at the boundary the one without face.
    #[must_use]
    #[inline]
    pub fn vertex_half_edge(&self, v: VertexId) -> HalfEdgeId {
        HalfEdgeId(self.vertex_half_edge[v.index()])
    }

    /// The half-edge of an edge with the smaller number. It always has a face.
    #[must_use]
    #[inline]
    pub fn edge_half_edge(&self, e: EdgeId) -> HalfEdgeId {
        HalfEdgeId(self.edge_half_edge[e.index()])
    }

    /// The half-edge that starts at the first vertex of a face.
    #[must_use]
    #[inline]
    pub fn face_half_edge(&self, f: FaceId) -> HalfEdgeId {
        HalfEdgeId(self.blocks.range(f.0).start)
    }

    /// How many vertices a face has.
    #[must_use]
    #[inline]
    pub fn face_degree(&self, f: FaceId) -> usize {
        self.blocks.range(f.0).len()
    }

    /// The half-edges of a face, in its order.
    pub fn face_half_edges(&self, f: FaceId) -> impl ExactSizeIterator<Item = HalfEdgeId> + use<> {
        self.blocks.range(f.0).map(HalfEdgeId)
    }

    /// The vertices of a face, in its order.
    pub fn face_vertices(&self, f: FaceId) -> impl ExactSizeIterator<Item = VertexId> + '_ {
        self.face_half_edges(f).map(|h| self.origin(h))
    }

    /// The two ends of an edge.
    #[must_use]
    pub fn edge_vertices(&self, e: EdgeId) -> [VertexId; 2] {
        let h = self.edge_half_edge(e);
        [self.origin(h), self.destination(h)]
    }
}
