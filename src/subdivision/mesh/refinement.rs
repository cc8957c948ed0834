//! The kinds of refinement, and what they make of the numbers of elements.

use super::{HalfEdgeMesh, MeshError};

/// How a scheme refines the connectivity of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Refinement {
    /// Each triangle becomes four: Loop, Butterfly.
    Triangles,
    /// Each face becomes as many quadrilaterals as it has corners: Catmull and Clark, Kobbelt.
    Quadrilaterals,
    /// Corners and edges are cut off, and each vertex, edge and face becomes a face: Doo and Sabin, on closed meshes.
    CutCorners,
}

impl Refinement {
    /// The refined connectivity.
    ///
    /// # Errors
    ///
    /// [`MeshError`] for faces that the refinement does not split, and for results that are too large.
    pub fn refine(self, mesh: &HalfEdgeMesh) -> Result<HalfEdgeMesh, MeshError> {
        match self {
            Self::Triangles => mesh.split_triangles(),
            Self::Quadrilaterals => mesh.split_into_quadrilaterals(),
            Self::CutCorners => mesh.cut_corners(),
        }
    }

    /// The numbers of vertices, edges and faces after one step; `None` for a mesh that it does not refine.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::{Refinement, solids};
    ///
    /// let cube = solids::cube::<f64>();
    /// assert_eq!(Refinement::Quadrilaterals.counts(cube.connectivity()), Some([26, 48, 24]));
    /// assert_eq!(Refinement::CutCorners.counts(cube.connectivity()), Some([24, 48, 26]));
    /// assert_eq!(Refinement::Triangles.counts(cube.connectivity()), None);
    /// ```
    #[must_use]
    pub fn counts(self, mesh: &HalfEdgeMesh) -> Option<[usize; 3]> {
        let refined = self.refine(mesh).ok()?;
        Some([
            refined.vertex_count(),
            refined.edge_count(),
            refined.face_count(),
        ])
    }
}

impl Refinement {
    /// The numbers of vertices, edges and faces after some steps, by formulas alone: nothing is refined.
    ///
    /// They are the true numbers, except for [`CutCorners`](Self::CutCorners) on a mesh with boundary, where they are upper bounds.
    /// Numbers beyond 128 bits stay at the largest one.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::{Refinement, solids};
    ///
    /// let cube = solids::cube::<f64>();
    /// assert_eq!(Refinement::Quadrilaterals.counts_after(cube.connectivity(), 2), [98, 192, 96]);
    /// let [_, _, faces] = Refinement::Triangles.counts_after(solids::octahedron::<f64>().connectivity(), 20);
    /// assert_eq!(faces, 8 << 40);
    /// ```
    ///
    /// # Arguments
    ///
    /// `mesh`: one that the refinement splits; for others the numbers mean nothing. `steps`: any number.
    #[must_use]
    pub fn counts_after(self, mesh: &HalfEdgeMesh, steps: u32) -> [u128; 3] {
        let [mut vertices, mut edges, mut faces] =
            [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()].map(|count| count as u128);
        let mut corners = mesh.corner_count() as u128;
        // Every step doubles the faces at least, so after 128 steps their number is beyond 128 bits.
        for _ in 0..steps.min(128) {
            let all = vertices.saturating_add(edges).saturating_add(faces);
            let twice = edges.saturating_mul(2);
            [vertices, edges, faces] = match self {
                Self::Triangles => [
                    vertices.saturating_add(edges),
                    twice.saturating_add(faces.saturating_mul(3)),
                    faces.saturating_mul(4),
                ],
                Self::Quadrilaterals => [all, twice.saturating_add(corners), corners],
                Self::CutCorners => [twice, twice.saturating_mul(2), all],
            };
            corners = faces.saturating_mul(4);
        }
        [vertices, edges, faces]
    }
}

impl HalfEdgeMesh {
    /// Cuts off corners and edges; the numbers are those of Doo and Sabin's scheme.
    ///
    /// Vertex h of the result is the corner of a face at the origin of half-edge h.
    /// First come the faces inside the old ones, then those across inner edges, then those around inner vertices.
    ///
    /// # Errors
    ///
    /// [`MeshError::FaceTooSmall`] if an inner vertex has two edges only.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::solids;
    ///
    /// let cut = solids::tetrahedron::<f64>().connectivity().cut_corners()?;
    /// assert_eq!((cut.vertex_count(), cut.edge_count(), cut.face_count()), (12, 24, 14));
    /// # Ok::<(), cagd::subdivision::MeshError>(())
    /// ```
    pub fn cut_corners(&self) -> Result<Self, MeshError> {
        let inside = self
            .faces()
            .map(|f| self.face_half_edges(f).map(|h| h.0).collect());
        let across = self
            .edges()
            .filter(|&e| !self.is_boundary_edge(e))
            .map(|e| {
                let h = self.edge_half_edge(e);
                let g = self.flip(h);
                [self.next(h), h, self.next(g), g].map(|h| h.0).to_vec()
            });
        let around = self
            .vertices()
            .filter(|&v| !self.is_boundary(v))
            .map(|v| self.vertex_ring(v).map(|h| h.0).collect());
        let faces: Vec<Vec<u32>> = inside.chain(across).chain(around).collect();
        Self::from_faces(self.corner_count(), &faces)
    }
}
