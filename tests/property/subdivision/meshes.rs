//! Random meshes, and the properties of the half-edge structure.
//!
//! A mesh is grown from a recipe that plants what is to be known of it: a surface of genus 0 to 3, a vertex of a valence
//! from 3 to 12, holes that do not touch each other.

use std::collections::BTreeSet;

use cagd::affine::Point;
use cagd::subdivision::{CatmullClark, HalfEdgeMesh, Mesh, SurfaceScheme, laws, solids};
use proptest::prelude::*;

use crate::generators::{for_all, for_all_of};
use crate::support::mutants::subdivision::meshes as mutants;
use crate::support::{holds, rejects};

/// A mesh in space.
pub type Space = Mesh<Point<f64, 3>>;

/// Which faces a random mesh has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Faces {
    Triangles,
    Quadrilaterals,
    /// Triangles, quadrilaterals and larger faces side by side.
    Mixed,
}

/// A random mesh with what was planted in it.
#[derive(Debug, Clone)]
pub struct Planted {
    pub mesh: Space,
    pub faces: Faces,
    pub genus: usize,
    /// How many faces were taken out; each leaves a boundary loop.
    pub holes: usize,
}

impl Planted {
    pub fn connectivity(&self) -> &HalfEdgeMesh {
        self.mesh.connectivity()
    }
}

/// Random numbers that a recipe draws from, one after the other, beginning again at the end.
struct Dice<'a> {
    numbers: &'a [u32],
    next: usize,
}

impl Dice<'_> {
    fn below(&mut self, bound: usize) -> usize {
        let number = self.numbers[self.next % self.numbers.len()];
        self.next += 1;
        number as usize % bound.max(1)
    }
}

/// Faces that share no vertex with each other, up to `count` of them.
fn apart(faces: &[Vec<u32>], count: usize, dice: &mut Dice) -> BTreeSet<usize> {
    let mut chosen = BTreeSet::new();
    let mut taken: BTreeSet<u32> = BTreeSet::new();
    for _ in 0..20 * count {
        let f = dice.below(faces.len());
        if chosen.len() < count && faces[f].iter().all(|v| !taken.contains(v)) {
            chosen.insert(f);
            taken.extend(&faces[f]);
        }
    }
    chosen
}

/// Flips edges opposite to a vertex, or edges at it, until it has this valence or nothing can be flipped any more.
fn with_valence(mesh: HalfEdgeMesh, valence: usize, dice: &mut Dice) -> HalfEdgeMesh {
    let v = cagd::subdivision::VertexId(dice.below(mesh.vertex_count()) as u32);
    let mut mesh = mesh;
    for _ in 0..60 {
        let now = mesh.valence(v);
        if now == valence {
            break;
        }
        let ring: Vec<_> = mesh.vertex_ring(v).collect();
        let h = ring[dice.below(ring.len())];
        // The edge opposite to v in the triangle of h, or the edge of h itself.
        let edge = if now < valence { mesh.next(h) } else { h };
        if let Some(flipped) = edge_flipped(&mesh, edge) {
            mesh = flipped;
        }
    }
    mesh
}

/// The triangle mesh in which the edge of `h` is the other diagonal of its two triangles.
///
/// `None` where that would make a vertex of valence below 3 or above 12, or a second edge between two vertices.
fn edge_flipped(mesh: &HalfEdgeMesh, h: cagd::subdivision::HalfEdgeId) -> Option<HalfEdgeMesh> {
    let g = mesh.flip(h);
    let (f, other) = (mesh.face(h)?, mesh.face(g)?);
    let (a, b) = (mesh.origin(h), mesh.origin(g));
    let [c, d] = [h, g].map(|h| mesh.origin(mesh.prev(h)));
    let joined = mesh.neighbours(c).any(|v| v == d);
    let poor = [a, b].iter().any(|&v| mesh.valence(v) <= 3);
    let rich = [c, d].iter().any(|&v| mesh.valence(v) >= 12);
    if c == d || joined || poor || rich {
        return None;
    }
    let mut faces = mesh.face_lists();
    faces[f.index()] = vec![a.0, d.0, c.0];
    faces[other.index()] = vec![d.0, b.0, c.0];
    HalfEdgeMesh::from_faces(mesh.vertex_count(), &faces).ok()
}

fn grown(
    kind: Faces,
    genus: usize,
    holes: usize,
    valence: usize,
    flat: bool,
    numbers: &[u32],
) -> Planted {
    let mut dice = Dice { numbers, next: 0 };
    let plate = solids::plate_with_holes::<f64>(genus);
    let start = solids::triangulated(&plate).expect("no diagonal of a cube's side is an edge");
    let triangles = with_valence(start.connectivity().clone(), valence, &mut dice);
    let connectivity = match kind {
        Faces::Triangles => triangles,
        Faces::Quadrilaterals => triangles.split_into_quadrilaterals().expect("a small mesh"),
        Faces::Mixed => merged(&triangles, &mut dice),
    };
    let mut faces = connectivity.face_lists();
    let taken = apart(&faces, holes, &mut dice);
    let mut index = 0;
    faces.retain(|_| {
        index += 1;
        !taken.contains(&(index - 1))
    });
    // A face without neighbours that share a vertex with it leaves no vertex alone: every vertex has three faces.
    let connectivity = HalfEdgeMesh::from_faces(connectivity.vertex_count(), &faces)
        .expect("faces that do not touch leave holes that do not touch");
    let points = (0..connectivity.vertex_count()).map(|v| {
        let coordinate = |dice: &mut Dice| dice.below(1 << 16) as f64 / 4096.0 - 8.0;
        let [x, y, z] = [(); 3].map(|()| coordinate(&mut dice));
        // Some points far from the origin, and equal ones.
        let place = match v % 7 {
            0 => [x + 1000.0, y, z],
            1 => [1.0, 1.0, 1.0],
            _ => [x, y, z],
        };
        Point::new(if flat {
            [place[0], place[1], 2.0]
        } else {
            place
        })
    });
    let points: Vec<_> = points.collect();
    Planted {
        mesh: Mesh::new(connectivity, points).expect("a finite point a vertex"),
        faces: kind,
        genus,
        holes: taken.len(),
    }
}

/// The mesh without some edges: pairs of neighbours become one face where that leaves every vertex three edges.
fn merged(mesh: &HalfEdgeMesh, dice: &mut Dice) -> HalfEdgeMesh {
    let mut mesh = mesh.clone();
    for _ in 0..mesh.face_count() / 3 {
        let e = cagd::subdivision::EdgeId(dice.below(mesh.edge_count()) as u32);
        let h = mesh.edge_half_edge(e);
        let g = mesh.flip(h);
        let (Some(f), Some(other)) = (mesh.face(h), mesh.face(g)) else {
            continue;
        };
        let ends = mesh.edge_vertices(e);
        if f == other || ends.iter().any(|&v| mesh.valence(v) <= 3) {
            continue;
        }
        let around = |start| {
            let mut along = vec![];
            let mut at = mesh.next(start);
            while at != start {
                along.push(mesh.origin(at).0);
                at = mesh.next(at);
            }
            along
        };
        let mut faces = mesh.face_lists();
        faces[f.index()] = [around(h), around(g)].concat();
        faces.remove(other.index());
        // Faces that meet in more than one edge would pass a vertex twice: then the edge stays.
        if let Ok(fewer) = HalfEdgeMesh::from_faces(mesh.vertex_count(), &faces) {
            mesh = fewer;
        }
    }
    mesh
}

/// Random meshes of these faces: closed and open, genus 0 to 3, with a vertex of a valence from 3 to 12.
pub fn meshes_of(kind: Faces) -> impl Strategy<Value = Planted> {
    meshes_with(kind, prop_oneof![2 => Just(0_usize), 3 => 1_usize..=3])
}

/// Random meshes of these faces with so many holes.
fn meshes_with(kind: Faces, holes: impl Strategy<Value = usize>) -> impl Strategy<Value = Planted> {
    let numbers = prop::collection::vec(any::<u32>(), 97);
    (
        0_usize..=3,
        holes,
        3_usize..=12,
        prop::bool::weighted(0.2),
        numbers,
    )
        .prop_map(move |(genus, holes, valence, flat, numbers)| {
            grown(kind, genus, holes, valence, flat, &numbers)
        })
}

/// Random triangle meshes.
pub fn triangle_meshes() -> impl Strategy<Value = Planted> {
    meshes_of(Faces::Triangles)
}

/// Random quadrilateral meshes.
pub fn quadrilateral_meshes() -> impl Strategy<Value = Planted> {
    meshes_of(Faces::Quadrilaterals)
}

/// Random closed quadrilateral meshes in which no face has two extraordinary vertices.
pub fn separated_meshes() -> impl Strategy<Value = Planted> {
    meshes_with(Faces::Quadrilaterals, Just(0)).prop_map(|planted| Planted {
        mesh: CatmullClark.refine(&planted.mesh).expect("a closed mesh"),
        ..planted
    })
}

/// Random meshes with any faces.
pub fn polygon_meshes() -> impl Strategy<Value = Planted> {
    prop_oneof![
        1 => triangle_meshes().boxed(),
        1 => quadrilateral_meshes().boxed(),
        2 => meshes_of(Faces::Mixed).boxed(),
    ]
}

#[test]
fn every_class_of_mesh_occurs() {
    use std::cell::RefCell;
    use std::collections::BTreeMap;

    let counts = RefCell::new(BTreeMap::<String, i32>::new());
    for valence in 3..=12 {
        for regular in ["triangles", "quadrilaterals"] {
            counts
                .borrow_mut()
                .insert(format!("valence {valence} among {regular}"), 0);
        }
    }
    let outcome = for_all(polygon_meshes(), |planted| {
        let mesh = planted.connectivity();
        let flat = planted.mesh.points().iter().all(|p| p[2] == 2.0);
        let degrees: BTreeSet<usize> = mesh.faces().map(|f| mesh.face_degree(f)).collect();
        let classes = [
            (format!("genus {}", planted.genus), true),
            (format!("{} holes", planted.holes), true),
            (format!("{:?}", planted.faces), true),
            ("flat".into(), flat),
            ("three kinds of faces".into(), degrees.len() >= 3),
            ("open".into(), !mesh.is_closed()),
        ];
        let mut counts = counts.borrow_mut();
        for (class, occurs) in classes {
            *counts.entry(class).or_insert(0) += i32::from(occurs);
        }
        let among = match planted.faces {
            Faces::Triangles => Some("triangles"),
            Faces::Quadrilaterals => Some("quadrilaterals"),
            Faces::Mixed => None,
        };
        let inner = mesh.vertices().filter(|&v| !mesh.is_boundary(v));
        let valences: BTreeSet<usize> = inner.map(|v| mesh.valence(v)).collect();
        if let Some(among) = among {
            for valence in valences {
                *counts
                    .entry(format!("valence {valence} among {among}"))
                    .or_insert(0) += 1;
            }
        }
        assert!(mesh.vertices().all(|v| (2..=12).contains(&mesh.valence(v))));
        cagd::law::Sides::new("statistics").equal(
            "always",
            [0.0],
            [0.0],
            cagd::law::Rounding::none(),
        )
    });
    assert_eq!(outcome, Ok(()));
    for (class, count) in counts.into_inner() {
        assert!(count >= 2, "{count} meshes of the class «{class}»");
    }
}

#[test]
fn valence() {
    type Valence = fn(&HalfEdgeMesh, cagd::subdivision::VertexId) -> usize;
    let law = |implementation: Valence| {
        for_all_of(64, polygon_meshes(), |planted| {
            laws::valence::<f64>(implementation, planted.connectivity())
        })
    };
    holds(law(HalfEdgeMesh::valence));
    rejects("faces are counted", law(mutants::faces_counted));
    rejects("half-edges with a face", law(mutants::half_edges_with_face));
    rejects("always regular", law(mutants::always_regular));
}

#[test]
fn half_edge() {
    use cagd::subdivision::HalfEdgeTables;

    type Construction = fn(usize, &[Vec<u32>]) -> HalfEdgeTables;
    let law = |implementation: Construction| {
        for_all_of(64, polygon_meshes(), |planted| {
            let mesh = planted.connectivity();
            let characteristic = 2 - 2 * planted.genus as i64 - planted.holes as i64;
            laws::half_edge::<f64>(
                implementation,
                mesh.vertex_count(),
                &mesh.face_lists(),
                characteristic,
            )
        })
    };
    holds(law(|vertices, faces| {
        HalfEdgeMesh::from_faces(vertices, faces)
            .expect("a mesh")
            .tables()
    }));
    rejects(
        "the flip is that of the next",
        law(mutants::flip_of_the_next),
    );
    rejects("prev is next", law(mutants::prev_is_next));
    rejects(
        "the end instead of the origin",
        law(mutants::end_instead_of_origin),
    );
    rejects(
        "an edge for every half-edge",
        law(mutants::edge_for_every_half_edge),
    );
    rejects(
        "the boundary runs backwards",
        law(mutants::boundary_backwards),
    );
    rejects("the boundary has a face", law(mutants::boundary_with_face));
}

#[test]
fn element_counts() {
    use cagd::subdivision::Refinement;

    type Counts = fn(Refinement, &HalfEdgeMesh) -> Option<[usize; 3]>;
    let law = |implementation: Counts| {
        for_all_of(64, polygon_meshes(), |planted| {
            laws::element_counts::<f64>(implementation, planted.connectivity())
        })
    };
    holds(law(|refinement, mesh| refinement.counts(mesh)));
    rejects(
        "the middle triangle is forgotten",
        law(mutants::middle_triangle_forgotten),
    );
    rejects("edges are only halved", law(mutants::edges_only_halved));
    rejects(
        "vertices of faces are forgotten",
        law(mutants::face_points_forgotten),
    );
}
