use cagd::check::claim;
use cagd::subdivision::{HalfEdgeMesh, HalfEdgeTables, solids};

/// The tables of a mesh with these faces.
fn tables(vertices: usize, faces: &[&[u32]]) -> HalfEdgeTables {
    HalfEdgeMesh::from_faces(vertices, faces)
        .expect("the faces of the tests make a mesh")
        .tables()
}

fn tetrahedron() -> HalfEdgeTables {
    tables(4, &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]])
}

/// A quadrilateral and two triangles.
fn fragment() -> HalfEdgeTables {
    tables(6, &[&[0, 1, 2, 3], &[2, 1, 4], &[3, 2, 5]])
}

fn probes() -> Vec<String> {
    let [closed, open] = [tetrahedron(), fragment()];
    // From 0 to 1 in the face 0, 1, 3; from 2 to 3 in the quadrilateral.
    cagd::probes![
        answer::ring(&closed, 3),
        answer::ring(&open, 2),
        answer::ring(&open, 4)
    ]
}

/// The half-edge from one vertex to another.
fn half_edge(tables: &HalfEdgeTables, from: usize, to: usize) -> usize {
    let runs = |&h: &usize| tables.origin[h] == from && tables.origin[tables.flip[h]] == to;
    (0..tables.flip.len())
        .find(runs)
        .expect("the vertices are neighbours")
}

fn compare(name: &str, tables: &HalfEdgeTables, from: usize, to: usize, expected: &[usize]) {
    claim("the neighbours of the vertex where h starts")
        .input(format!("{name}, h from vertex {from} to vertex {to}"))
        .equal(
            answer::ring(tables, half_edge(tables, from, to)),
            expected.to_vec(),
        );
}

const TETRAHEDRON: &str = "faces 0 2 1, 0 1 3, 1 2 3, 2 0 3";
const FRAGMENT: &str = "faces 0 1 2 3, 2 1 4, 3 2 5";

/// Why: a closed mesh has the simple case only.
#[test]
fn closed() {
    compare(TETRAHEDRON, &tetrahedron(), 0, 1, &[1, 3, 2]);
    compare(TETRAHEDRON, &tetrahedron(), 0, 3, &[3, 2, 1]);
    compare(TETRAHEDRON, &tetrahedron(), 3, 2, &[2, 0, 1]);
}

/// Why: the first neighbour alone is a smaller claim.
#[test]
fn begins_with_the_end() {
    let tables = tetrahedron();
    for (from, to) in [(0, 1), (1, 3), (2, 0)] {
        claim("the first neighbour")
            .input(format!(
                "{TETRAHEDRON}, h from vertex {from} to vertex {to}"
            ))
            .equal(
                answer::ring(&tables, half_edge(&tables, from, to))
                    .first()
                    .copied(),
                Some(to),
            );
    }
}

/// Why: the easy case at the boundary: h is the first of the vertex.
#[test]
fn from_the_first_boundary_edge() {
    compare(FRAGMENT, &fragment(), 2, 5, &[5, 3, 1, 4]);
    compare(
        "one triangle 0 1 2",
        &tables(3, &[&[0, 1, 2]]),
        1,
        2,
        &[2, 0],
    );
}

/// Why: some faces lie on either side of h.
#[test]
fn from_within() {
    compare(FRAGMENT, &fragment(), 2, 3, &[5, 3, 1, 4]);
    compare(FRAGMENT, &fragment(), 2, 1, &[5, 3, 1, 4]);
}

/// Why: h has no face.
#[test]
fn from_outside() {
    compare(FRAGMENT, &fragment(), 2, 4, &[5, 3, 1, 4]);
}

/// Why: all half-edges of larger meshes, with and without boundary.
#[test]
fn everywhere() {
    let meshes = [
        ("a torus of triangles, 4 × 3", solids::torus_triangles(4, 3)),
        ("a cube", solids::cube::<f64>().connectivity().clone()),
        ("seven triangles around a vertex", solids::triangle_fan(7)),
        (
            "a grid of 3 × 2 quadrilaterals",
            solids::grid::<f64>(3, 2).connectivity().clone(),
        ),
    ];
    for (name, mesh) in &meshes {
        let tables = mesh.tables();
        for h in mesh.half_edges() {
            let vertex = mesh.origin(h);
            let mut expected: Vec<usize> = mesh.neighbours(vertex).map(|v| v.index()).collect();
            let end = mesh.destination(h).index();
            if !mesh.is_boundary(vertex) {
                let first = expected
                    .iter()
                    .position(|&v| v == end)
                    .expect("a neighbour");
                expected.rotate_left(first);
            }
            compare(name, &tables, vertex.index(), end, &expected);
        }
    }
}
