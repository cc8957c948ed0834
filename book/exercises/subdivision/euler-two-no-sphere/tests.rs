use std::collections::{BTreeMap, BTreeSet};

use cagd::check::claim;

type Faces = Vec<Vec<u32>>;

fn probes() -> Vec<String> {
    cagd::probes![answer::counterexample()]
}

/// The answer, if it is of the form that is asked for.
fn read() -> Faces {
    let faces = answer::counterexample();
    claim("the number of faces").holds(
        (1..=100).contains(&faces.len()),
        "1 to 100 faces",
        format!("{} faces", faces.len()),
    );
    for face in &faces {
        let different: BTreeSet<u32> = face.iter().copied().collect();
        claim("the form of a face")
            .input(format!("{face:?}"))
            .holds(
                (3..=12).contains(&face.len()) && different.len() == face.len(),
                "3 to 12 different vertices",
                format!(
                    "{} vertices, {} of them different",
                    face.len(),
                    different.len()
                ),
            );
    }
    let used: BTreeSet<u32> = faces.iter().flatten().copied().collect();
    claim("the numbers of the vertices").holds(
        used.iter().copied().eq(0..used.len() as u32),
        "the numbers from 0 on without a gap",
        format!("{used:?}"),
    );
    faces
}

/// How often each pair of vertices is the way from a corner of a face to the next.
fn directed_edges(faces: &Faces) -> BTreeMap<(u32, u32), usize> {
    let mut edges = BTreeMap::new();
    for face in faces {
        for (i, &start) in face.iter().enumerate() {
            *edges
                .entry((start, face[(i + 1) % face.len()]))
                .or_default() += 1;
        }
    }
    edges
}

/// What can be reached from the first of these, by links in both directions.
fn reached(first: u32, links: &[(u32, u32)]) -> BTreeSet<u32> {
    let mut reached = BTreeSet::from([first]);
    loop {
        let before = reached.len();
        for &(a, b) in links {
            if reached.contains(&a) || reached.contains(&b) {
                reached.extend([a, b]);
            }
        }
        if reached.len() == before {
            return reached;
        }
    }
}

#[test]
fn edges_have_two_faces() {
    let faces = read();
    let edges = directed_edges(&faces);
    for (&(a, b), &count) in &edges {
        let back = edges.get(&(b, a)).copied().unwrap_or(0);
        claim("the faces at an edge")
            .input(format!("the edge of {a} and {b}"))
            .holds(
                count == 1 && back == 1,
                "one face from each vertex to the other",
                format!("{count} from {a} to {b}, {back} from {b} to {a}"),
            );
    }
}

/// Why: it is a condition of the claim, and its failure has words of its own.
#[test]
fn connected() {
    let faces = read();
    let edges: Vec<(u32, u32)> = directed_edges(&faces).into_keys().collect();
    let all: BTreeSet<u32> = faces.iter().flatten().copied().collect();
    let reached = reached(0, &edges);
    claim("the mesh is connected").holds(
        reached == all,
        "each vertex can be reached from vertex 0",
        format!("{} of {} can", reached.len(), all.len()),
    );
}

#[test]
fn euler_two() {
    let faces = read();
    let undirected = |&(a, b): &(u32, u32)| (a.min(b), a.max(b));
    let edges: BTreeSet<_> = directed_edges(&faces).keys().map(undirected).collect();
    let vertices: BTreeSet<u32> = faces.iter().flatten().copied().collect();
    let [v, e, f] = [vertices.len(), edges.len(), faces.len()].map(|n| n as i64);
    claim("V − E + F")
        .input(format!("V = {v}, E = {e}, F = {f}"))
        .equal(v - e + f, 2);
}

/// Connected, closed and with V − E + F = 2, a mesh is a sphere if and only if each vertex has one ring of faces.
#[test]
fn no_sphere() {
    let faces = read();
    let mut around: BTreeMap<u32, Vec<(u32, u32)>> = BTreeMap::new();
    for face in &faces {
        let n = face.len();
        for (i, &vertex) in face.iter().enumerate() {
            let corner = (face[(i + n - 1) % n], face[(i + 1) % n]);
            around.entry(vertex).or_default().push(corner);
        }
    }
    let one_ring = |corners: &Vec<(u32, u32)>| {
        let ends: BTreeSet<u32> = corners.iter().flat_map(|&(a, b)| [a, b]).collect();
        reached(corners[0].0, corners) == ends
    };
    claim("the mesh is not a sphere").holds(
        !around.values().all(one_ring),
        "a vertex whose faces are more than one ring",
        "one ring of faces at each vertex: if the other conditions hold, it is a sphere",
    );
}
