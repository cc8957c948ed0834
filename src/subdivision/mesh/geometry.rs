//! A mesh with a point at every vertex.

use super::{FaceId, HalfEdgeMesh, MeshError, VertexId};
use crate::affine::Affine;
use crate::scalar::Scalar;

/// A half-edge mesh and one point a vertex.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::subdivision::{Mesh, VertexId};
///
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::new);
/// let triangle = Mesh::from_faces(corners.to_vec(), &[[0, 1, 2]])?;
/// assert_eq!(triangle.point(VertexId(1)), &corners[1]);
/// assert_eq!(triangle.connectivity().face_count(), 1);
/// # Ok::<(), cagd::subdivision::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh<P> {
    connectivity: HalfEdgeMesh,
    points: Vec<P>,
}

impl<P: Affine> Mesh<P> {
    /// A mesh with these points.
    ///
    /// # Errors
    ///
    /// [`MeshError::PointCount`] unless there is one point a vertex, [`MeshError::NotFinite`] for a coordinate that is NaN or infinite.
    pub fn new(connectivity: HalfEdgeMesh, points: Vec<P>) -> Result<Self, MeshError> {
        if points.len() != connectivity.vertex_count() {
            return Err(MeshError::PointCount {
                vertices: connectivity.vertex_count(),
                points: points.len(),
            });
        }
        let mesh = Self {
            connectivity,
            points,
        };
        mesh.check_points()?;
        Ok(mesh)
    }

    /// A mesh from points and lists of vertices; see [`HalfEdgeMesh::from_faces`].
    ///
    /// # Errors
    ///
    /// As [`HalfEdgeMesh::from_faces`] and [`new`](Self::new).
    pub fn from_faces<F: AsRef<[u32]>>(points: Vec<P>, faces: &[F]) -> Result<Self, MeshError> {
        Self::new(HalfEdgeMesh::from_faces(points.len(), faces)?, points)
    }

    /// A mesh without elements, whose memory a refinement can use again and again.
    pub(in crate::subdivision) fn buffer() -> Self {
        Self {
            connectivity: HalfEdgeMesh::buffer(),
            points: vec![],
        }
    }

    /// Both parts, for who makes them belong together again and calls [`check_points`](Self::check_points) then.
    pub(in crate::subdivision) fn parts_mut(&mut self) -> (&mut HalfEdgeMesh, &mut Vec<P>) {
        (&mut self.connectivity, &mut self.points)
    }

    /// All coordinates are finite.
    pub(in crate::subdivision) fn check_points(&self) -> Result<(), MeshError> {
        let finite = |point: &P| point.coordinates().iter().all(Scalar::is_finite);
        match self.points.iter().position(|point| !finite(point)) {
            None => Ok(()),
            Some(index) => Err(MeshError::NotFinite {
                vertex: VertexId::at(index),
                point: written(&self.points[index]),
            }),
        }
    }

    /// The connectivity.
    #[must_use]
    pub fn connectivity(&self) -> &HalfEdgeMesh {
        &self.connectivity
    }

    /// The points, by vertex.
    #[must_use]
    pub fn points(&self) -> &[P] {
        &self.points
    }

    /// The point of a vertex.
    ///
    /// # Panics
    ///
    /// If the mesh has no such vertex.
    #[must_use]
    pub fn point(&self, v: VertexId) -> &P {
        &self.points[v.index()]
    }

    /// The points of a face, in its order.
    ///
    /// # Panics
    ///
    /// If the mesh has no such face.
    pub fn face_points(&self, f: FaceId) -> impl ExactSizeIterator<Item = &P> + '_ {
        self.connectivity.face_vertices(f).map(|v| self.point(v))
    }

    /// The same connectivity with other points.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new), for a point that is not finite.
    pub fn map<Q: Affine>(&self, point: impl FnMut(&P) -> Q) -> Result<Mesh<Q>, MeshError> {
        Mesh::new(
            self.connectivity.clone(),
            self.points.iter().map(point).collect(),
        )
    }

    /// The connectivity and the points.
    #[must_use]
    pub fn into_parts(self) -> (HalfEdgeMesh, Vec<P>) {
        (self.connectivity, self.points)
    }
}

/// The coordinates of a point as `(x, y, z)`.
fn written<P: Affine>(point: &P) -> String {
    let coordinates = point.coordinates().iter().map(ToString::to_string);
    format!("({})", coordinates.collect::<Vec<_>>().join(", "))
}
