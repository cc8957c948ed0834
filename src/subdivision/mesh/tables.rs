//! The half-edges as plain tables, to be read and compared.

use super::HalfEdgeMesh;

/// What every half-edge knows, by its number.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::HalfEdgeMesh;
///
/// let triangle = HalfEdgeMesh::from_faces(3, &[[0, 1, 2]])?.tables();
/// assert_eq!(triangle.next, [1, 2, 0, 5, 3, 4]);
/// assert_eq!(triangle.face, [Some(0), Some(0), Some(0), None, None, None]);
/// # Ok::<(), cagd::subdivision::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HalfEdgeTables {
    /// The vertex where it starts.
    pub origin: Vec<usize>,
    /// The other half of its edge.
    pub flip: Vec<usize>,
    /// The next half-edge around its face, or along the boundary.
    pub next: Vec<usize>,
    /// The half-edge before it.
    pub prev: Vec<usize>,
    /// Its edge.
    pub edge: Vec<usize>,
    /// Its face.
    pub face: Vec<Option<usize>>,
}

impl HalfEdgeMesh {
    /// The half-edges as plain tables.
    #[must_use]
    pub fn tables(&self) -> HalfEdgeTables {
        let all = || self.half_edges();
        HalfEdgeTables {
            origin: all().map(|h| self.origin(h).index()).collect(),
            flip: all().map(|h| self.flip(h).index()).collect(),
            next: all().map(|h| self.next(h).index()).collect(),
            prev: all().map(|h| self.prev(h).index()).collect(),
            edge: all().map(|h| self.edge(h).index()).collect(),
            face: all()
                .map(|h| self.face(h).map(super::FaceId::index))
                .collect(),
        }
    }
}
