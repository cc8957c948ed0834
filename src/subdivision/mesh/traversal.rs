//! Walking on a mesh: rings around vertices, boundary loops, components, and the genus they tell.

use super::connectivity::Blocks;
use super::{EdgeId, FaceId, HalfEdgeId, HalfEdgeMesh, VertexId};

/// The half-edges that start at one vertex, counterclockwise; see [`HalfEdgeMesh::vertex_ring`].
#[derive(Debug, Clone)]
pub struct VertexRing<'a> {
    mesh: &'a HalfEdgeMesh,
    first: HalfEdgeId,
    next: Option<HalfEdgeId>,
}

impl Iterator for VertexRing<'_> {
    type Item = HalfEdgeId;

    fn next(&mut self) -> Option<HalfEdgeId> {
        let h = self.next?;
        let around = self.mesh.around_origin(h);
        self.next = (around != self.first).then_some(around);
        Some(h)
    }
}

impl HalfEdgeMesh {
    /// The next half-edge counterclockwise around the origin of `h`: flip(prev(h)).
    #[must_use]
    #[inline]
    pub fn around_origin(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.flip(self.prev(h))
    }

    /// The half-edges that start at a vertex, counterclockwise; their ends are the one-ring.
    ///
    /// At a boundary vertex they run from one boundary edge to the other, the half-edge without face last.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::{HalfEdgeMesh, VertexId};
    ///
    /// // Two triangles in a square.
    /// let mesh = HalfEdgeMesh::from_faces(4, &[[0, 1, 2], [0, 2, 3]])?;
    /// let ring: Vec<_> = mesh.vertex_ring(VertexId(0)).map(|h| mesh.destination(h)).collect();
    /// assert_eq!(ring, [1, 2, 3].map(VertexId));
    /// # Ok::<(), cagd::subdivision::MeshError>(())
    /// ```
    #[must_use]
    pub fn vertex_ring(&self, v: VertexId) -> VertexRing<'_> {
        let stored = self.vertex_half_edge(v);
        let first = if self.face(stored).is_none() {
            self.around_origin(stored)
        } else {
            stored
        };
        VertexRing {
            mesh: self,
            first,
            next: Some(first),
        }
    }

    /// The other ends of the edges at a vertex, counterclockwise; see [`vertex_ring`](Self::vertex_ring).
    pub fn neighbours(&self, v: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.vertex_ring(v).map(|h| self.destination(h))
    }

    /// The valence of a vertex: the number of its edges.
    #[must_use]
    pub fn valence(&self, v: VertexId) -> usize {
        self.vertex_ring(v).count()
    }

    /// Whether a vertex lies on the boundary.
    #[must_use]
    #[inline]
    pub fn is_boundary(&self, v: VertexId) -> bool {
        self.face(self.vertex_half_edge(v)).is_none()
    }

    /// Whether an edge lies on the boundary: it belongs to one face only.
    #[must_use]
    #[inline]
    pub fn is_boundary_edge(&self, e: EdgeId) -> bool {
        self.face(self.flip(self.edge_half_edge(e))).is_none()
    }

    /// Whether a vertex has the valence of a regular mesh of this kind of faces.
    ///
    /// Inside that is 6 for triangles and 4 for quadrilaterals, at the boundary 4 and 3.
    /// `None` for faces with another number of vertices: no valence is regular for them.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::{VertexId, solids};
    ///
    /// let cube = solids::cube::<f64>();
    /// assert_eq!(cube.connectivity().valence(VertexId(0)), 3);
    /// assert_eq!(cube.connectivity().is_regular(VertexId(0), 4), Some(false), "extraordinary");
    /// ```
    #[must_use]
    pub fn is_regular(&self, v: VertexId, face_degree: usize) -> Option<bool> {
        let regular = match (face_degree, self.is_boundary(v)) {
            (3, false) => 6,
            (4, false) | (3, true) => 4,
            (4, true) => 3,
            _ => return None,
        };
        Some(self.valence(v) == regular)
    }

    /// The number of vertices of each face, if all have the same.
    #[must_use]
    pub fn uniform_face_degree(&self) -> Option<usize> {
        match self.blocks {
            Blocks::Uniform { degree, .. } => Some(degree as usize),
            Blocks::Mixed { .. } => None,
        }
    }

    /// Whether there is no boundary.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.boundary_next.is_empty()
    }

    /// The loops of the boundary, each as its half-edges in order.
    #[must_use]
    pub fn boundary_loops(&self) -> Vec<Vec<HalfEdgeId>> {
        let first = self.corner_count();
        let mut seen = vec![false; self.boundary_next.len()];
        let mut loops = vec![];
        for start in 0..seen.len() {
            let mut along = vec![];
            let mut h = HalfEdgeId::at(first + start);
            while !std::mem::replace(&mut seen[h.index() - first], true) {
                along.push(h);
                h = self.next(h);
            }
            if !along.is_empty() {
                loops.push(along);
            }
        }
        loops
    }

    /// The Euler characteristic V − E + F.
    ///
    /// A connected surface of genus g with b boundary loops has 2 − 2g − b.
    #[must_use]
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count() as i64 - self.edge_count() as i64 + self.face_count() as i64
    }

    /// The pieces that hang together, each as its faces.
    #[must_use]
    pub fn components(&self) -> Vec<Vec<FaceId>> {
        let mut seen = vec![false; self.face_count()];
        let mut components = vec![];
        for start in self.faces() {
            if std::mem::replace(&mut seen[start.index()], true) {
                continue;
            }
            let mut faces = vec![start];
            let mut done = 0;
            while let Some(&f) = faces.get(done) {
                done += 1;
                for h in self.face_half_edges(f) {
                    let neighbour = self.face(self.flip(h));
                    if let Some(g) = neighbour
                        && !std::mem::replace(&mut seen[g.index()], true)
                    {
                        faces.push(g);
                    }
                }
            }
            components.push(faces);
        }
        components
    }

    /// The sum of the genera of all components: how many handles the surface has.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::solids;
    ///
    /// for genus in 0..=3 {
    ///     let plate = solids::plate_with_holes::<f64>(genus);
    ///     assert_eq!(plate.connectivity().euler_characteristic(), 2 - 2 * genus as i64);
    ///     assert_eq!(plate.connectivity().genus(), genus);
    /// }
    /// ```
    #[must_use]
    pub fn genus(&self) -> usize {
        let components = self.components().len() as i64;
        let loops = self.boundary_loops().len() as i64;
        ((2 * components - loops - self.euler_characteristic()) / 2) as usize
    }

    /// The vertices of every face: what [`from_faces`](Self::from_faces) was given.
    #[must_use]
    pub fn face_lists(&self) -> Vec<Vec<u32>> {
        self.faces()
            .map(|f| self.face_vertices(f).map(|v| v.0).collect())
            .collect()
    }
}
