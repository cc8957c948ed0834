//! What a subdivision scheme for surfaces is.

use thiserror::Error;

use super::{CosineError, FaceId, Mesh, MeshError, VertexId};
use crate::affine::Affine;

/// A rule that makes a finer mesh of a mesh.
///
/// # Examples
///
/// A scheme that only inserts midpoints:
///
/// ```
/// use cagd::affine::Affine;
/// use cagd::scalar::Scalar;
/// use cagd::subdivision::{Mesh, SchemeError, SurfaceScheme, solids};
///
/// struct Midpoints;
///
/// impl<P: Affine> SurfaceScheme<P> for Midpoints {
///     fn name(&self) -> &'static str {
///         "midpoints"
///     }
///
///     fn refine(&self, mesh: &Mesh<P>) -> Result<Mesh<P>, SchemeError> {
///         let old = mesh.connectivity();
///         let mut points = mesh.points().to_vec();
///         points.extend(old.edges().map(|e| {
///             let [a, b] = old.edge_vertices(e).map(|v| mesh.point(v));
///             a.lerp(b, P::Scalar::from_ratio(1, 2))
///         }));
///         Ok(Mesh::new(old.split_triangles()?, points)?)
///     }
/// }
///
/// let octahedron = solids::octahedron::<f64>();
/// assert_eq!(Midpoints.refine_times(&octahedron, 2)?.connectivity().face_count(), 8 * 16);
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
pub trait SurfaceScheme<P: Affine> {
    /// What the scheme is called.
    fn name(&self) -> &'static str;

    /// One step.
    ///
    /// # Errors
    ///
    /// [`SchemeError`] if the scheme has no rule for an element of the mesh, or if the result is too large.
    fn refine(&self, mesh: &Mesh<P>) -> Result<Mesh<P>, SchemeError>;

    /// Several steps.
    ///
    /// # Errors
    ///
    /// As [`refine`](Self::refine).
    fn refine_times(&self, mesh: &Mesh<P>, steps: usize) -> Result<Mesh<P>, SchemeError> {
        let mut refined = mesh.clone();
        for _ in 0..steps {
            refined = self.refine(&refined)?;
        }
        Ok(refined)
    }
}

/// Why a scheme does not refine a mesh.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SchemeError {
    /// The refined mesh does not exist.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A weight is irrational, and the numbers of the mesh are rational.
    #[error(transparent)]
    Cosine(#[from] CosineError),
    /// A face has a number of vertices that the scheme has no rule for.
    #[error(
        "{scheme} needs faces with {expected} vertices, but {face} has {found}; split it first"
    )]
    FaceDegree {
        /// The scheme.
        scheme: &'static str,
        /// Which face.
        face: FaceId,
        /// The number of vertices that is needed.
        expected: usize,
        /// How many vertices it has.
        found: usize,
    },
    /// A vertex has a valence that the scheme has no rule for.
    #[error("{scheme} has no rule for {vertex}, which has valence {valence}: {reason}")]
    Valence {
        /// The scheme.
        scheme: &'static str,
        /// Which vertex.
        vertex: VertexId,
        /// Its valence.
        valence: usize,
        /// Why there is no rule, and what to do.
        reason: &'static str,
    },
    /// Exactly one sharp edge ends at a vertex, and the limit there is not known.
    #[error(
        "{scheme} has no limit stencil at {vertex}, where a crease ends; tag the vertex as a corner, or take the vertex after some steps"
    )]
    CreaseEnd {
        /// The scheme.
        scheme: &'static str,
        /// The vertex.
        vertex: VertexId,
    },
    /// The mesh has a boundary, and the scheme has no rule there.
    #[error("{scheme} has no rule at the boundary, where {vertex} lies; close the mesh")]
    Boundary {
        /// The scheme.
        scheme: &'static str,
        /// A vertex on the boundary.
        vertex: VertexId,
    },
}
