use cagd::check::claim;
use cagd::subdivision::{HalfEdgeMesh, HalfEdgeTables};

/// A closed mesh, one triangle, and three faces of different size.
fn right() -> [HalfEdgeTables; 3] {
    let tables = |vertices, faces: &[&[u32]]| {
        HalfEdgeMesh::from_faces(vertices, faces)
            .expect("the faces of the tests make a mesh")
            .tables()
    };
    [
        tables(4, &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]]),
        tables(3, &[&[0, 1, 2]]),
        tables(6, &[&[0, 1, 2, 3], &[2, 1, 4], &[3, 2, 5]]),
    ]
}

/// All right tables, changed.
fn changed(change: impl Fn(&mut HalfEdgeTables)) -> Vec<HalfEdgeTables> {
    right()
        .map(|mut tables| {
            change(&mut tables);
            tables
        })
        .into()
}

/// The next half-edge is taken for the flip, and all edges for one.
fn next_for_flip() -> Vec<HalfEdgeTables> {
    changed(|tables| {
        tables.flip = tables.next.clone();
        tables.edge.fill(0);
    })
}

/// A single half-edge that is everything to itself.
fn alone() -> Vec<HalfEdgeTables> {
    vec![HalfEdgeTables {
        origin: vec![0],
        flip: vec![0],
        next: vec![0],
        prev: vec![0],
        edge: vec![0],
        face: vec![Some(0)],
    }]
}

fn next_for_prev() -> Vec<HalfEdgeTables> {
    changed(|tables| tables.prev = tables.next.clone())
}

/// Where there is no face, prev is not written.
fn no_prev_outside() -> Vec<HalfEdgeTables> {
    changed(|tables| {
        for (h, prev) in tables.prev.iter_mut().enumerate() {
            if tables.face[h].is_none() {
                *prev = h;
            }
        }
    })
}

fn a_face_for_each() -> Vec<HalfEdgeTables> {
    changed(|tables| tables.face = (0..tables.face.len()).map(Some).collect())
}

fn an_edge_for_each() -> Vec<HalfEdgeTables> {
    changed(|tables| tables.edge = (0..tables.edge.len()).collect())
}

fn end_for_origin() -> Vec<HalfEdgeTables> {
    changed(|tables| {
        tables.origin = tables.next.iter().map(|&h| tables.origin[h]).collect();
    })
}

fn holds(all: &[HalfEdgeTables]) -> bool {
    all.iter().all(|tables| answer::law(tables).judge().is_ok())
}

fn probes() -> Vec<String> {
    cagd::probes![
        holds(&right()),
        holds(&next_for_flip()),
        holds(&alone()),
        holds(&next_for_prev()),
        holds(&no_prev_outside()),
        holds(&a_face_for_each()),
        holds(&an_edge_for_each()),
        holds(&end_for_origin()),
    ]
}

fn fails(what: &str, all: &[HalfEdgeTables]) {
    claim("the law on wrong tables").input(what).holds(
        !holds(all),
        "the law is violated",
        "it holds",
    );
}

#[test]
fn it_holds_for_half_edges() {
    for tables in right() {
        claim("the law on right tables").law(&answer::law(&tables));
    }
}

#[test]
fn it_fails_for_wrong_flips() {
    fails(
        "flip leads to the next half-edge, and there is one edge only",
        &next_for_flip(),
    );
}

#[test]
fn it_fails_for_a_half_edge_alone() {
    fails(
        "a single half-edge, which is its own flip, next and prev",
        &alone(),
    );
}

/// Why: a reader sees at once which table is not asked.
#[test]
fn it_fails_for_wrong_prev() {
    fails("prev leads to the next half-edge", &next_for_prev());
}

#[test]
fn it_fails_for_wrong_prev_at_the_boundary() {
    fails(
        "prev of a half-edge without face is itself",
        &no_prev_outside(),
    );
}

/// Why: a reader sees at once which table is not asked.
#[test]
fn it_fails_for_wrong_faces() {
    fails("each half-edge has a face of its own", &a_face_for_each());
}

/// Why: a reader sees at once which table is not asked.
#[test]
fn it_fails_for_wrong_edges() {
    fails("each half-edge has an edge of its own", &an_edge_for_each());
}

#[test]
fn it_fails_for_wrong_origins() {
    fails(
        "origin is the vertex where the half-edge ends",
        &end_for_origin(),
    );
}
