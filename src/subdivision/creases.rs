//! Sharp edges and corners, and what they do to the rules of a scheme.

use std::fmt;

use super::{EdgeId, HalfEdgeMesh, VertexId};

/// Which edges of a mesh are sharp, and which vertices are corners.
///
/// Edges of the boundary are sharp whether they are tagged or not.
/// A scheme passes the tags on: both halves of a sharp edge are sharp, and a corner stays one.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{CatmullClark, Creases, VertexId, VertexRule, solids};
///
/// let cube = solids::cube::<f64>();
/// let mesh = cube.connectivity();
/// let bottom = mesh.faces().next().expect("a cube has faces");
/// let sharp = mesh.face_half_edges(bottom).map(|h| mesh.edge(h));
/// let creases = Creases::new(mesh, sharp, [])?;
/// let [smooth, on_crease] = [6, 0].map(|v| creases.rule(mesh, VertexId(v)));
/// assert!(matches!(on_crease, VertexRule::Crease(_)));
///
/// let (_, finer) = CatmullClark.refine_creased(&cube, &creases)?;
/// assert_eq!(finer.sharp_edges().count(), 2 * 4);
/// # assert_eq!(smooth, VertexRule::Smooth);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Creases {
    sharp: Vec<bool>,
    corner: Vec<bool>,
}

/// The rule for the vertex point of a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VertexRule {
    /// The rule of the scheme: no sharp edge, or one (a dart).
    Smooth,
    /// The cubic rule for curves, with the neighbours along the two sharp edges.
    Crease([VertexId; 2]),
    /// The vertex stays: three or more sharp edges, or tagged as a corner.
    Corner,
}

/// A tag for an element that the mesh does not have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CreaseError {
    /// There is no such edge.
    #[error(
        "{edge} cannot be sharp: the mesh has {count} edges, numbered from 0; name one of them"
    )]
    Edge {
        /// The edge.
        edge: EdgeId,
        /// How many there are.
        count: usize,
    },
    /// There is no such vertex.
    #[error(
        "{vertex} cannot be a corner: the mesh has {count} vertices, numbered from 0; name one of them"
    )]
    Vertex {
        /// The vertex.
        vertex: VertexId,
        /// How many there are.
        count: usize,
    },
}

impl Creases {
    /// No tags for any mesh, to be read only: what is beyond the tags is not tagged.
    pub(super) const UNTAGGED: Self = Self {
        sharp: vec![],
        corner: vec![],
    };

    /// No tags: only the boundary is sharp.
    #[must_use]
    pub fn none(mesh: &HalfEdgeMesh) -> Self {
        Self {
            sharp: vec![false; mesh.edge_count()],
            corner: vec![false; mesh.vertex_count()],
        }
    }

    /// These edges are sharp, and these vertices are corners.
    ///
    /// # Errors
    ///
    /// [`CreaseError`] for an edge or a vertex that `mesh` does not have.
    pub fn new(
        mesh: &HalfEdgeMesh,
        sharp: impl IntoIterator<Item = EdgeId>,
        corners: impl IntoIterator<Item = VertexId>,
    ) -> Result<Self, CreaseError> {
        let mut creases = Self::none(mesh);
        for edge in sharp {
            let count = creases.sharp.len();
            *creases
                .sharp
                .get_mut(edge.index())
                .ok_or(CreaseError::Edge { edge, count })? = true;
        }
        for vertex in corners {
            let count = creases.corner.len();
            *creases
                .corner
                .get_mut(vertex.index())
                .ok_or(CreaseError::Vertex { vertex, count })? = true;
        }
        Ok(creases)
    }

    /// Whether an edge is tagged as sharp or lies on the boundary.
    ///
    /// An edge beyond the tags, as of another mesh, is not tagged.
    #[must_use]
    pub fn is_sharp(&self, mesh: &HalfEdgeMesh, e: EdgeId) -> bool {
        self.sharp.get(e.index()).copied().unwrap_or(false) || mesh.is_boundary_edge(e)
    }

    /// The edges that are tagged as sharp.
    pub fn sharp_edges(&self) -> impl Iterator<Item = EdgeId> + '_ {
        let tagged = self.sharp.iter().enumerate();
        tagged
            .filter(|(_, sharp)| **sharp)
            .map(|(e, _)| EdgeId::at(e))
    }

    /// The vertices that are tagged as corners.
    pub fn corners(&self) -> impl Iterator<Item = VertexId> + '_ {
        let tagged = self.corner.iter().enumerate();
        tagged
            .filter(|(_, corner)| **corner)
            .map(|(v, _)| VertexId::at(v))
    }

    /// The rule for the vertex point of `v`.
    #[must_use]
    pub fn rule(&self, mesh: &HalfEdgeMesh, v: VertexId) -> VertexRule {
        if self.corner.get(v.index()).copied().unwrap_or(false) {
            return VertexRule::Corner;
        }
        let mut sharp = mesh
            .vertex_ring(v)
            .filter(|&h| self.is_sharp(mesh, mesh.edge(h)))
            .map(|h| mesh.destination(h));
        match (sharp.next(), sharp.next(), sharp.next()) {
            (_, _, Some(_)) => VertexRule::Corner,
            (Some(a), Some(b), None) => VertexRule::Crease([a, b]),
            _ => VertexRule::Smooth,
        }
    }

    /// Whether exactly one sharp edge ends at `v`, which then is a dart; its own rule is the smooth one.
    #[must_use]
    pub fn is_dart(&self, mesh: &HalfEdgeMesh, v: VertexId) -> bool {
        // The smooth rule is for one sharp edge at the most.
        let mut edges = mesh.vertex_ring(v).map(|h| mesh.edge(h));
        self.rule(mesh, v) == VertexRule::Smooth && edges.any(|e| self.is_sharp(mesh, e))
    }

    /// The tags after one split of all edges: the halves of edge e are 2e and 2e + 1, old vertices keep their numbers.
    pub(super) fn refined(&self, refined: &HalfEdgeMesh) -> Self {
        let halves = self.sharp.iter().flat_map(|&sharp| [sharp; 2]);
        let mut finer = Self::none(refined);
        finer
            .sharp
            .iter_mut()
            .zip(halves)
            .for_each(|(tag, sharp)| *tag = sharp);
        finer
            .corner
            .iter_mut()
            .zip(&self.corner)
            .for_each(|(tag, &corner)| *tag = corner);
        finer
    }
}

impl fmt::Display for VertexRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Smooth => f.write_str("smooth"),
            Self::Crease([a, b]) => write!(f, "crease from {a} to {b}"),
            Self::Corner => f.write_str("corner"),
        }
    }
}
