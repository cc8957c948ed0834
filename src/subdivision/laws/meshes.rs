//! Laws of meshes.

use std::collections::BTreeSet;

use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;
use crate::subdivision::{HalfEdgeMesh, HalfEdgeTables, Refinement, VertexId};

fn numbers<T: Scalar>(list: impl IntoIterator<Item = i64>) -> Vec<T> {
    list.into_iter().map(T::from_integer).collect()
}

fn written(mesh: &HalfEdgeMesh) -> String {
    format!(
        "{} vertices, faces {:?}",
        mesh.vertex_count(),
        mesh.face_lists()
    )
}

/// `subdivision-valence`: the valence of a vertex is the number of its edges, which is regular for all that splitting adds.
///
/// `implementation(mesh, v)` must give the valence.
/// The right side counts the other ends of edges in the lists of the faces.
///
/// # Rounding
///
/// None: the numbers are small and whole.
pub fn valence<T: Scalar>(
    implementation: impl Fn(&HalfEdgeMesh, VertexId) -> usize,
    mesh: &HalfEdgeMesh,
) -> Sides<T> {
    let mut ends = vec![BTreeSet::new(); mesh.vertex_count()];
    for face in mesh.face_lists() {
        for (i, &v) in face.iter().enumerate() {
            let w = face[(i + 1) % face.len()];
            ends[v as usize].insert(w);
            ends[w as usize].insert(v);
        }
    }
    let found: Vec<i64> = mesh
        .vertices()
        .map(|v| implementation(mesh, v) as i64)
        .collect();
    let sum = found.iter().sum();
    let mut sides = Sides::new(written(mesh))
        .equal(
            "the number of edges at each vertex",
            numbers(found),
            numbers(ends.iter().map(|ends| ends.len() as i64)),
            Rounding::none(),
        )
        .equal(
            "Σ valences = 2E",
            numbers([sum]),
            numbers([2 * mesh.edge_count() as i64]),
            Rounding::none(),
        );
    let refinements = [
        (
            "triangles",
            mesh.split_triangles(),
            [6, 4],
            mesh.vertex_count(),
        ),
        // The middles of faces come last; their valence is that of their face.
        (
            "quadrilaterals",
            mesh.split_into_quadrilaterals(),
            [4, 3],
            mesh.vertex_count(),
        ),
    ];
    for (kind, refined, [inside, at_boundary], old) in refinements {
        let Ok(refined) = refined else { continue };
        let middles = (old..old + mesh.edge_count()).map(VertexId::at);
        let regular = |v: VertexId| {
            if refined.is_boundary(v) {
                at_boundary
            } else {
                inside
            }
        };
        sides = sides.equal(
            format!("the middles of edges are regular vertices of {kind}"),
            numbers(middles.clone().map(|v| implementation(&refined, v) as i64)),
            numbers(middles.map(regular)),
            Rounding::none(),
        );
    }
    sides
}

/// `subdivision-half-edge`: flip, next, prev, origin, edge and face belong together as they should.
///
/// `implementation(vertices, faces)` must give the tables of the mesh with these lists of faces; their number of vertices
/// minus edges plus faces must be `characteristic`.
///
/// # Rounding
///
/// None: the numbers are small and whole.
pub fn half_edge<T: Scalar>(
    implementation: impl Fn(usize, &[Vec<u32>]) -> HalfEdgeTables,
    vertex_count: usize,
    faces: &[Vec<u32>],
    characteristic: i64,
) -> Sides<T> {
    let tables = implementation(vertex_count, faces);
    let count = tables.origin.len();
    let all = || 0..count;
    // A number that does not exist stays as it is: the comparison then fails.
    let at = |table: &[usize], h: usize| table.get(h).copied().unwrap_or(usize::MAX);
    let flip = |h| at(&tables.flip, h);
    let next = |h| at(&tables.next, h);
    let prev = |h| at(&tables.prev, h);
    let origin = |h| at(&tables.origin, h);
    let edge = |h| at(&tables.edge, h);
    let face = |h: usize| {
        tables
            .face
            .get(h)
            .copied()
            .flatten()
            .map_or(-1, |f| f as i64)
    };
    let list = |of: &dyn Fn(usize) -> usize| numbers::<T>(all().map(|h| of(h) as i64));
    let equal = |sides: Sides<T>, name: &str, left: Vec<T>, right: Vec<T>| {
        sides.equal(name, left, right, Rounding::none())
    };
    let same = list(&|h| h);
    let mut sides = Sides::new(format!("{vertex_count} vertices, faces {faces:?}"));
    sides = equal(
        sides,
        "flip(flip(h)) = h",
        list(&|h| flip(flip(h))),
        same.clone(),
    );
    sides = equal(
        sides,
        "flip(h) ≠ h",
        numbers(all().map(|h| i64::from(flip(h) == h))),
        numbers(all().map(|_| 0)),
    );
    sides = equal(
        sides,
        "prev(next(h)) = h",
        list(&|h| prev(next(h))),
        same.clone(),
    );
    sides = equal(sides, "next(prev(h)) = h", list(&|h| next(prev(h))), same);
    sides = equal(
        sides,
        "next keeps the face",
        numbers(all().map(|h| face(next(h)))),
        numbers(all().map(face)),
    );
    sides = equal(
        sides,
        "v(flip(h)) = v(next(h))",
        list(&|h| origin(flip(h))),
        list(&|h| origin(next(h))),
    );
    sides = equal(
        sides,
        "e(flip(h)) = e(h)",
        list(&|h| edge(flip(h))),
        list(&edge),
    );
    sides = equal(
        sides,
        "v(flip(prev(h))) = v(h)",
        list(&|h| origin(flip(prev(h)))),
        list(&origin),
    );
    // Around a vertex: as many steps as half-edges start there.
    let starting = |v: usize| all().filter(|&h| origin(h) == v).count() as i64;
    let orbit = |h: usize| {
        let mut steps = 1;
        let mut at = flip(prev(h));
        while at != h && steps <= count as i64 {
            at = flip(prev(at));
            steps += 1;
        }
        steps
    };
    sides = equal(
        sides,
        "h → flip(prev(h)) passes all half-edges of the vertex",
        numbers(all().map(orbit)),
        numbers(all().map(|h| starting(origin(h)))),
    );
    let corners: Vec<usize> = all().filter(|&h| face(h) >= 0).collect();
    let around = |f: usize| {
        let start = corners.iter().copied().find(|&h| face(h) == f as i64);
        let mut at = start.unwrap_or(usize::MAX);
        faces[f]
            .iter()
            .map(|_| {
                let v = origin(at);
                at = next(at);
                v as i64
            })
            .collect::<Vec<_>>()
    };
    sides = equal(
        sides,
        "next runs through the vertices of each face in order",
        numbers((0..faces.len()).flat_map(around)),
        numbers(faces.iter().flatten().map(|&v| i64::from(v))),
    );
    let edges = all().map(edge).collect::<BTreeSet<_>>().len();
    let degrees: usize = faces.iter().map(Vec::len).sum();
    let boundary = count - corners.len();
    sides = equal(
        sides,
        "|H| = 2|E|, and the faces have Σ deg f half-edges",
        numbers([count as i64, count as i64]),
        numbers([2 * edges as i64, (degrees + boundary) as i64]),
    );
    equal(
        sides,
        "V − E + F = 2 − 2g − loops",
        numbers([vertex_count as i64 - edges as i64 + faces.len() as i64]),
        numbers([characteristic]),
    )
}

/// `subdivision-element-counts`: what a step makes of V vertices, E edges and F faces.
///
/// `implementation(refinement, mesh)` must give the numbers of vertices, edges and faces after a step of the refinement,
/// and `None` for meshes that it does not refine.
///
/// # Rounding
///
/// None: the numbers are small and whole.
pub fn element_counts<T: Scalar>(
    implementation: impl Fn(Refinement, &HalfEdgeMesh) -> Option<[usize; 3]>,
    mesh: &HalfEdgeMesh,
) -> Sides<T> {
    let (v, e, f) = (mesh.vertex_count(), mesh.edge_count(), mesh.face_count());
    let d: usize = mesh.faces().map(|face| mesh.face_degree(face)).sum();
    let degree = mesh.uniform_face_degree();
    let mut sides = Sides::new(written(mesh));
    let expected = [
        (
            Refinement::Triangles,
            degree == Some(3),
            [v + e, 2 * e + 3 * f, 4 * f],
        ),
        (Refinement::Quadrilaterals, true, [v + e + f, 2 * e + d, d]),
        // The same on quadrilateral meshes alone, as the statement has it for Kobbelt's scheme.
        (
            Refinement::Quadrilaterals,
            degree == Some(4),
            [v + e + f, 2 * e + 4 * f, 4 * f],
        ),
        (
            Refinement::CutCorners,
            mesh.is_closed(),
            [2 * e, 4 * e, v + e + f],
        ),
    ];
    for (refinement, applies, expected) in expected {
        if !applies {
            continue;
        }
        let found = implementation(refinement, mesh)
            .unwrap_or_default()
            .map(|n| n as i64);
        let expected = expected.map(|n| n as i64);
        sides = sides
            .equal(
                format!("{refinement:?}: vertices, edges and faces"),
                numbers(found),
                numbers(expected),
                Rounding::none(),
            )
            .equal(
                format!("{refinement:?}: V − E + F is kept"),
                numbers([found[0] - found[1] + found[2]]),
                numbers([mesh.euler_characteristic()]),
                Rounding::none(),
            );
    }
    sides
}
