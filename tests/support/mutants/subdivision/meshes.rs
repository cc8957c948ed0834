//! Wrong half-edges and wrong counts.

use cagd::subdivision::{HalfEdgeMesh, HalfEdgeTables, Refinement, VertexId};

/// Counts faces instead of edges, which is one too few at the boundary.
pub fn faces_counted(mesh: &HalfEdgeMesh, v: VertexId) -> usize {
    mesh.face_lists()
        .iter()
        .filter(|face| face.contains(&v.0))
        .count()
}

/// Counts the half-edges that start at the vertex and have a face.
pub fn half_edges_with_face(mesh: &HalfEdgeMesh, v: VertexId) -> usize {
    mesh.vertex_ring(v)
        .filter(|&h| mesh.face(h).is_some())
        .count()
}

/// Believes that all vertices are regular.
pub fn always_regular(mesh: &HalfEdgeMesh, v: VertexId) -> usize {
    match (mesh.uniform_face_degree(), mesh.is_boundary(v)) {
        (Some(3), false) => 6,
        (Some(3), true) | (_, false) => 4,
        (_, true) => 3,
    }
}

fn tables(vertices: usize, faces: &[Vec<u32>]) -> HalfEdgeTables {
    HalfEdgeMesh::from_faces(vertices, faces)
        .expect("a mesh")
        .tables()
}

/// Takes the flip of the next half-edge.
pub fn flip_of_the_next(vertices: usize, faces: &[Vec<u32>]) -> HalfEdgeTables {
    let tables = tables(vertices, faces);
    let flip = tables.next.iter().map(|&next| tables.flip[next]).collect();
    HalfEdgeTables { flip, ..tables }
}

/// Runs forwards where it should run backwards.
pub fn prev_is_next(vertices: usize, faces: &[Vec<u32>]) -> HalfEdgeTables {
    let tables = tables(vertices, faces);
    HalfEdgeTables {
        prev: tables.next.clone(),
        ..tables
    }
}

/// Stores the vertex where a half-edge ends.
pub fn end_instead_of_origin(vertices: usize, faces: &[Vec<u32>]) -> HalfEdgeTables {
    let tables = tables(vertices, faces);
    let origin = tables
        .flip
        .iter()
        .map(|&flip| tables.origin[flip])
        .collect();
    HalfEdgeTables { origin, ..tables }
}

/// Numbers half-edges instead of edges.
pub fn edge_for_every_half_edge(vertices: usize, faces: &[Vec<u32>]) -> HalfEdgeTables {
    let tables = tables(vertices, faces);
    HalfEdgeTables {
        edge: (0..tables.edge.len()).collect(),
        ..tables
    }
}

/// Links the half-edges of the boundary in the direction of the faces.
pub fn boundary_backwards(vertices: usize, faces: &[Vec<u32>]) -> HalfEdgeTables {
    let mut tables = tables(vertices, faces);
    for h in 0..tables.face.len() {
        if tables.face[h].is_none() {
            (tables.next[h], tables.prev[h]) = (tables.prev[h], tables.next[h]);
        }
    }
    tables
}

/// Gives the half-edges of the boundary the face on the other side.
pub fn boundary_with_face(vertices: usize, faces: &[Vec<u32>]) -> HalfEdgeTables {
    let tables = tables(vertices, faces);
    let other = |h: usize| tables.face[h].or(tables.face[tables.flip[h]]);
    let face = (0..tables.face.len()).map(other).collect();
    HalfEdgeTables { face, ..tables }
}

/// Counts three triangles for one.
pub fn middle_triangle_forgotten(
    refinement: Refinement,
    mesh: &HalfEdgeMesh,
) -> Option<[usize; 3]> {
    let [v, e, f] = refinement.counts(mesh)?;
    Some(match refinement {
        Refinement::Triangles => [v, e, f - mesh.face_count()],
        _ => [v, e, f],
    })
}

/// Forgets the edges inside the old faces.
pub fn edges_only_halved(refinement: Refinement, mesh: &HalfEdgeMesh) -> Option<[usize; 3]> {
    let [v, _, f] = refinement.counts(mesh)?;
    Some([v, 2 * mesh.edge_count(), f])
}

/// Forgets the vertices in the middles of faces.
pub fn face_points_forgotten(refinement: Refinement, mesh: &HalfEdgeMesh) -> Option<[usize; 3]> {
    let [v, e, f] = refinement.counts(mesh)?;
    Some(match refinement {
        Refinement::Quadrilaterals => [v - mesh.face_count(), e, f],
        _ => [v, e, f],
    })
}
