//! From the lists of a file to a mesh.

use super::{Attribute, Dropped, MeshFileError, MeshFileProblem, Place, Space};
use crate::affine::Point;
use crate::subdivision::{FaceId, Mesh, MeshError, VertexId};

/// A mesh that was read, what was left out, and where its elements stand in the file.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile {
    mesh: Space,
    dropped: Vec<Dropped>,
    vertex_places: Vec<Place>,
    face_places: Vec<Place>,
}

impl MeshFile {
    /// The mesh: vertices and faces in the order of the file, faces with all their vertices.
    #[must_use]
    pub fn mesh(&self) -> &Space {
        &self.mesh
    }

    /// The mesh, alone.
    #[must_use]
    pub fn into_mesh(self) -> Space {
        self.mesh
    }

    /// What the file says and the mesh does not keep; to be told to whoever brought it.
    #[must_use]
    pub fn dropped(&self) -> &[Dropped] {
        &self.dropped
    }

    /// Where a vertex stands; `None` if the mesh has no such vertex.
    #[must_use]
    pub fn vertex_place(&self, v: VertexId) -> Option<Place> {
        self.vertex_places.get(v.index()).copied()
    }

    /// Where a face stands; `None` if the mesh has no such face.
    #[must_use]
    pub fn face_place(&self, f: FaceId) -> Option<Place> {
        self.face_places.get(f.index()).copied()
    }
}

/// The lists of a file, while it is being read.
#[derive(Debug, Clone, Default)]
pub(crate) struct Polygons {
    points: Vec<Point<f64, 3>>,
    vertex_places: Vec<Place>,
    /// The vertices of all faces, one face behind the other.
    corners: Vec<u32>,
    /// Of every face where it ends in `corners`.
    ends: Vec<usize>,
    face_places: Vec<Place>,
    dropped: Vec<Dropped>,
}

impl Polygons {
    pub(crate) fn point_count(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn add_point(&mut self, coordinates: [f64; 3], place: Place) {
        self.points.push(Point::new(coordinates));
        self.vertex_places.push(place);
    }

    /// Adds a vertex, counted from 0, to the face that is being read.
    pub(crate) fn add_corner(&mut self, vertex: u32) {
        self.corners.push(vertex);
    }

    pub(crate) fn end_face(&mut self, place: Place) {
        self.ends.push(self.corners.len());
        self.face_places.push(place);
    }

    /// Notes something that the mesh does not keep.
    pub(crate) fn drop_all(&mut self, attribute: Attribute, count: usize, place: Place) {
        match self.dropped.iter_mut().find(|d| d.attribute == attribute) {
            Some(dropped) => dropped.count = dropped.count.saturating_add(count),
            None => self.dropped.push(Dropped {
                attribute,
                count,
                first: place,
            }),
        }
    }

    /// Notes one more of what the mesh does not keep.
    pub(crate) fn drop_one(&mut self, attribute: Attribute, place: Place) {
        self.drop_all(attribute, 1, place);
    }

    /// The mesh; vertices without a face are left out, for no scheme has a rule for them.
    ///
    /// `first` is the number that the format gives to the first vertex.
    pub(crate) fn finish(mut self, first: usize) -> Result<MeshFile, MeshFileError> {
        if self.ends.is_empty() {
            let vertices = self.points.len();
            return Err(MeshFileProblem::NoFace { vertices }.anywhere());
        }
        self.check_corners(first)?;
        let kept = self.drop_unused();
        let Self {
            points,
            vertex_places,
            corners,
            ends,
            face_places,
            dropped,
        } = self;
        let mut start = 0;
        let faces: Vec<&[u32]> = ends
            .iter()
            .map(|&end| &corners[std::mem::replace(&mut start, end)..end])
            .collect();
        let mesh = Mesh::from_faces(points, &faces).map_err(|error| {
            let places = (vertex_places.as_slice(), face_places.as_slice());
            in_the_file(error, &kept, places)
        })?;
        Ok(MeshFile {
            mesh,
            dropped,
            vertex_places,
            face_places,
        })
    }

    /// Every face names vertices that exist.
    fn check_corners(&self, first: usize) -> Result<(), MeshFileError> {
        let vertices = self.points.len();
        let dangling = self.corners.iter().position(|&v| v as usize >= vertices);
        let Some(at) = dangling else { return Ok(()) };
        let face = self.ends.partition_point(|&end| end <= at);
        Err(MeshFileProblem::NoVertex {
            index: u64::from(self.corners[at]) + first as u64,
            vertices,
            first,
        }
        .at(self.face_places[face]))
    }

    /// Leaves out the vertices without a face; returns the number in the file of every vertex that is kept.
    fn drop_unused(&mut self) -> Vec<u32> {
        let mut number = vec![u32::MAX; self.points.len()];
        for &v in &self.corners {
            number[v as usize] = 0;
        }
        let mut kept = vec![];
        for (v, number) in number.iter_mut().enumerate() {
            if *number == 0 {
                *number = kept.len() as u32;
                kept.push(v as u32);
            } else {
                self.drop_one(Attribute::UnusedVertices, self.vertex_places[v]);
            }
        }
        if kept.len() < number.len() {
            for v in &mut self.corners {
                *v = number[*v as usize];
            }
            self.points = kept.iter().map(|&v| self.points[v as usize]).collect();
            let places = kept.iter().map(|&v| self.vertex_places[v as usize]);
            self.vertex_places = places.collect();
        }
        kept
    }
}

/// A refusal of the lists with the places of the elements that it names; vertices get their numbers in the file.
fn in_the_file(
    mut error: MeshError,
    kept: &[u32],
    (vertex_places, face_places): (&[Place], &[Place]),
) -> MeshFileError {
    let (vertices, faces) = error.elements_mut();
    let mut named: Vec<(String, Place)> = vec![];
    let mut places_of_faces = vec![];
    for face in faces {
        if let Some(&place) = face_places.get(face.index()) {
            named.push((face.to_string(), place));
            places_of_faces.push(place);
        }
    }
    let mut places_of_vertices = vec![];
    for vertex in vertices {
        if let Some((&place, &number)) = vertex_places
            .get(vertex.index())
            .zip(kept.get(vertex.index()))
        {
            *vertex = VertexId(number);
            named.push((vertex.to_string(), place));
            places_of_vertices.push(place);
        }
    }
    // What is wrong shows at the face that comes last.
    let place = places_of_faces.into_iter().max();
    let place = place.or_else(|| places_of_vertices.into_iter().max());
    MeshFileError {
        place,
        problem: MeshFileProblem::Mesh { error, named },
    }
}
