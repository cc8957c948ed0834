//! What every scheme for surfaces keeps, whatever its weights are.
//!
//! Each property is stated once and tried for all schemes; each refuses a spoiled version of each scheme.

use std::collections::{BTreeMap, BTreeSet};

use cagd::affine::Point;
use cagd::law::{Rounding, Sides};
use cagd::subdivision::{
    Butterfly, CatmullClark, DooSabin, FaceId, HalfEdgeMesh, Kobbelt, Loop, Mesh, Refinement,
    SchemeError, SurfaceScheme, VertexId, laws::Refined,
};
use proptest::prelude::*;

use super::meshes::{Planted, Space, polygon_meshes, separated_meshes, triangle_meshes};
use crate::generators::for_all_of;
use crate::support::mutants::subdivision::invariants as mutants;
use crate::support::mutants::subdivision::invariants::{Spoiled, Step};
use crate::support::{Outcome, holds, rejects};

type Place = Point<f64, 3>;

/// A scheme, and what its step must be like.
struct Scheme {
    name: &'static str,
    step: Step,
    refinement: Refinement,
    interpolates: bool,
    /// Meshes that it refines.
    meshes: fn() -> BoxedStrategy<Planted>,
}

fn schemes() -> [Scheme; 5] {
    [
        Scheme {
            name: "Loop",
            step: |mesh| Loop.refine(mesh),
            refinement: Refinement::Triangles,
            interpolates: false,
            meshes: || triangle_meshes().boxed(),
        },
        Scheme {
            name: "Butterfly",
            step: |mesh| Butterfly::MODIFIED.refine(mesh),
            refinement: Refinement::Triangles,
            interpolates: true,
            meshes: || triangle_meshes().boxed(),
        },
        Scheme {
            name: "Catmull-Clark",
            step: |mesh| CatmullClark.refine(mesh),
            refinement: Refinement::Quadrilaterals,
            interpolates: false,
            meshes: || polygon_meshes().boxed(),
        },
        Scheme {
            name: "Doo-Sabin",
            step: |mesh| DooSabin.refine(mesh),
            refinement: Refinement::CutCorners,
            interpolates: false,
            meshes: || polygon_meshes().boxed(),
        },
        Scheme {
            name: "Kobbelt",
            step: |mesh| Kobbelt.refine(mesh),
            refinement: Refinement::Quadrilaterals,
            interpolates: true,
            meshes: || separated_meshes().boxed(),
        },
    ]
}

/// Meshes are much work, those of Kobbelt's scheme the most.
fn cases(scheme: &Scheme) -> u32 {
    if scheme.name == "Kobbelt" { 12 } else { 40 }
}

/// The absolute weights of a new point sum to less than 3: with Kobbelt's virtual points to 9/8 + 8/8 at the most.
const WEIGHTS: f64 = 3.0;

/// A new point is a sum, or a mean of means, that passes at most 64 roundings, those of its weights among them:
/// valences are at most 12, faces have at most 16 corners.
const ROUNDINGS: usize = 64;

/// One property for all of these schemes; it holds, and it rejects each of the mutants.
fn for_all_schemes<I, S>(
    schemes: impl IntoIterator<Item = Scheme>,
    inputs: impl Fn(&Scheme) -> S,
    property: impl Fn(&Scheme, &dyn Fn(&Space) -> Refined<Place>, &I) -> Sides<f64>,
    mutants: &[(&str, Spoiled)],
) where
    S: Strategy<Value = I>,
    I: std::fmt::Debug,
{
    for scheme in schemes {
        let judged = |step: &dyn Fn(&Space) -> Refined<Place>| -> Outcome {
            for_all_of(cases(&scheme), inputs(&scheme), |input| {
                property(&scheme, step, input)
            })
            .map_err(|violation| format!("{}: {violation}", scheme.name))
        };
        holds(judged(&scheme.step));
        for (name, mutant) in mutants {
            rejects(
                &format!("{}: {name}", scheme.name),
                judged(&|mesh| mutant(scheme.step, mesh)),
            );
        }
    }
}

/// The violation of a step that refuses its mesh: 1 = 0.
fn refused(sides: Sides<f64>, error: &SchemeError) -> Sides<f64> {
    sides.equal(
        format!("the scheme refines the mesh: {error}"),
        [1.0],
        [0.0],
        Rounding::none(),
    )
}

fn shown(mesh: &Space) -> Sides<f64> {
    let lists = mesh.connectivity().face_lists();
    Sides::new(format!("faces {lists:?}, points {:?}", mesh.points()))
}

fn coordinates(points: &[Place]) -> Vec<f64> {
    let all = points.iter().flat_map(|p| [p[0], p[1], p[2]]);
    all.collect()
}

fn largest(mesh: &Space) -> f64 {
    let all = coordinates(mesh.points()).into_iter();
    all.fold(0.0, |largest: f64, x| largest.max(x.abs()))
}

/// Takes p to the products of the rows with p, plus the shift.
#[derive(Debug, Clone, Copy)]
struct Map {
    rows: [[f64; 3]; 3],
    shift: [f64; 3],
}

impl Map {
    fn apply(&self, p: &Place) -> Place {
        Point::new([0, 1, 2].map(|i: usize| {
            let row = self.rows[i];
            row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + self.shift[i]
        }))
    }
}

/// Affine maps, those that flatten space and those that shift far among them.
fn maps() -> impl Strategy<Value = Map> {
    let entry = || prop_oneof![3 => -4.0..4.0, 1 => Just(0.0), 1 => Just(1.0)];
    let shift = prop_oneof![3 => -8.0..8.0, 1 => Just(1000.0)];
    let rows = prop::array::uniform3(prop::array::uniform3(entry()));
    (rows, prop::array::uniform3(shift)).prop_map(|(rows, shift)| Map { rows, shift })
}

#[test]
fn affine_invariance() {
    for_all_schemes(
        schemes(),
        |scheme| ((scheme.meshes)(), maps()),
        |_, step, (Planted { mesh, .. }, map)| {
            let moved = mesh.map(|p| map.apply(p)).expect("moderate numbers");
            let sides = shown(mesh);
            match (step(&moved), step(mesh)) {
                (Ok(before), Ok(after)) => {
                    let after = after.map(|p| map.apply(p)).expect("moderate numbers");
                    // A row has the sum 12, a shift is at most 1000.
                    let size = WEIGHTS * (12.0 * largest(mesh) + 1000.0);
                    sides.equal(
                        "the image refined is the image of what is refined",
                        coordinates(before.points()),
                        coordinates(after.points()),
                        Rounding::new(2 * (ROUNDINGS + 6), size),
                    )
                }
                (Err(error), _) | (_, Err(error)) => refused(sides, &error),
            }
        },
        &[
            ("pulled to the origin", mutants::pulled_to_the_origin),
            ("bent", mutants::bent),
            ("raised", mutants::raised),
        ],
    );
}

#[test]
fn planes_stay_planes() {
    let slopes = || prop::array::uniform3(prop_oneof![2 => -4.0..4.0, 1 => Just(0.0)]);
    for_all_schemes(
        schemes(),
        |scheme| ((scheme.meshes)(), slopes()),
        |_, step, (Planted { mesh, .. }, [a, b, c])| {
            let height = |p: &Place| a * p[0] + b * p[1] + c;
            let flat = mesh.map(|p| Point::new([p[0], p[1], height(p)]));
            let flat = flat.expect("moderate numbers");
            let sides = shown(&flat);
            match step(&flat) {
                Ok(refined) => sides.equal(
                    "z = ax + by + c",
                    refined.points().iter().map(|p| p[2]),
                    refined.points().iter().map(height),
                    Rounding::new(2 * (ROUNDINGS + 4), WEIGHTS * (8.0 * largest(mesh) + 4.0)),
                ),
                Err(error) => refused(sides, &error),
            }
        },
        &[("bent", mutants::bent), ("raised", mutants::raised)],
    );
}

#[test]
fn counts_and_euler_characteristic() {
    for_all_schemes(
        schemes(),
        |scheme| (scheme.meshes)(),
        |scheme, step, planted| {
            let old = planted.connectivity();
            let sides = shown(&planted.mesh);
            let refined = match step(&planted.mesh) {
                Ok(refined) => refined,
                Err(error) => return refused(sides, &error),
            };
            let new = refined.connectivity();
            let [v, e, f] = [old.vertex_count(), old.edge_count(), old.face_count()];
            let corners = old.corner_count();
            let inner_edges = old.edges().filter(|&e| !old.is_boundary_edge(e)).count();
            let inner_vertices = old.vertices().filter(|&v| !old.is_boundary(v)).count();
            let expected = match scheme.refinement {
                Refinement::Triangles => [v + e, 2 * e + 3 * f, 4 * f],
                Refinement::Quadrilaterals => [v + e + f, 2 * e + corners, corners],
                Refinement::CutCorners => [
                    corners,
                    corners + 2 * inner_edges,
                    f + inner_edges + inner_vertices,
                ],
            };
            let found = [new.vertex_count(), new.edge_count(), new.face_count()];
            let whole = |numbers: [usize; 3]| numbers.map(|n| n as f64);
            let characteristic = 2.0 - 2.0 * planted.genus as f64 - planted.holes as f64;
            sides
                .equal(
                    "vertices, edges and faces",
                    whole(found),
                    whole(expected),
                    Rounding::none(),
                )
                .equal(
                    "V − E + F = 2 − 2g − loops; the loops stay",
                    [
                        new.euler_characteristic() as f64,
                        new.boundary_loops().len() as f64,
                    ],
                    [characteristic, planted.holes as f64],
                    Rounding::none(),
                )
        },
        &[
            ("a face is lost", mutants::face_lost),
            ("two steps", mutants::two_steps),
        ],
    );
}

#[test]
fn interpolating_schemes_keep_the_vertices() {
    for_all_schemes(
        schemes().into_iter().filter(|scheme| scheme.interpolates),
        |scheme| (scheme.meshes)(),
        |_, step, Planted { mesh, .. }| match step(mesh) {
            Ok(refined) => shown(mesh).equal(
                "old vertices",
                coordinates(&refined.points()[..mesh.points().len()]),
                coordinates(mesh.points()),
                Rounding::none(),
            ),
            Err(error) => refused(shown(mesh), &error),
        },
        &[
            ("a vertex is moved", mutants::first_vertex_moved),
            ("raised", mutants::raised),
        ],
    );
}

/// Other numbers for the vertices and the faces of a mesh, and where the lists of its faces begin and how they run.
#[derive(Debug, Clone)]
struct Relabelling {
    /// The old number of each new vertex.
    vertices: Vec<u32>,
    /// The old number of each new face.
    faces: Vec<u32>,
    /// By how many corners the list of each new face begins later.
    turns: Vec<usize>,
    /// The faces run the other way, as seen from the other side.
    reversed: bool,
}

impl Relabelling {
    fn none(mesh: &HalfEdgeMesh) -> Self {
        Self {
            vertices: (0..mesh.vertex_count() as u32).collect(),
            faces: (0..mesh.face_count() as u32).collect(),
            turns: vec![0; mesh.face_count()],
            reversed: false,
        }
    }

    fn apply(&self, mesh: &Space) -> Space {
        let old = mesh.connectivity();
        let mut number = vec![0; self.vertices.len()];
        for (new, &v) in self.vertices.iter().enumerate() {
            number[v as usize] = new as u32;
        }
        let list = |(&f, &turn): (&u32, &usize)| {
            let list = old.face_vertices(FaceId(f)).map(|v| number[v.index()]);
            let mut list: Vec<u32> = list.collect();
            let turn = turn % list.len();
            list.rotate_left(turn);
            if self.reversed {
                list.reverse();
            }
            list
        };
        let faces: Vec<_> = self.faces.iter().zip(&self.turns).map(list).collect();
        let points = self.vertices.iter().map(|&v| *mesh.point(VertexId(v)));
        Mesh::from_faces(points.collect(), &faces).expect("the same mesh with other numbers")
    }

    /// The vertices after a step on the relabelled mesh, in its order, by the old numbers of what they belong to.
    fn names(&self, refinement: Refinement, mesh: &HalfEdgeMesh) -> Vec<Name> {
        let vertex = |v: VertexId| self.vertices[v.index()];
        if refinement == Refinement::CutCorners {
            let corners = mesh.faces().flat_map(|f| {
                let face = self.faces[f.index()];
                mesh.face_vertices(f)
                    .map(move |v| Name::Corner(face, vertex(v)))
            });
            return corners.collect();
        }
        let vertices = mesh.vertices().map(|v| Name::Vertex(vertex(v)));
        let edges = mesh.edges().map(|e| {
            let [a, b] = mesh.edge_vertices(e).map(vertex);
            Name::Edge(a.min(b), a.max(b))
        });
        let faces = self.faces.iter().map(|&f| Name::Face(f));
        let with_faces = refinement == Refinement::Quadrilaterals;
        vertices
            .chain(edges)
            .chain(faces.filter(|_| with_faces))
            .collect()
    }
}

/// What a new vertex belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Name {
    Vertex(u32),
    Edge(u32, u32),
    Face(u32),
    /// A face, and a vertex of it.
    Corner(u32, u32),
}

/// The points and the faces of a refined mesh by the names of its vertices; each face begins with its smallest name.
fn by_name(
    refined: &Space,
    names: &[Name],
    reversed: bool,
) -> (BTreeMap<Name, Place>, BTreeSet<Vec<Name>>) {
    let points = names.iter().copied().zip(refined.points().iter().copied());
    let faces = refined.connectivity().face_lists().into_iter().map(|list| {
        let mut face: Vec<Name> = list.iter().map(|&v| names[v as usize]).collect();
        if reversed {
            face.reverse();
        }
        let smallest = (0..face.len()).min_by_key(|&i| face[i]).unwrap_or(0);
        face.rotate_left(smallest);
        face
    });
    (points.collect(), faces.collect())
}

/// A mesh with other numbers for its elements.
fn relabelled(meshes: BoxedStrategy<Planted>) -> impl Strategy<Value = (Planted, Relabelling)> {
    meshes.prop_flat_map(|planted| {
        let none = Relabelling::none(planted.connectivity());
        let turns = prop::collection::vec(0..4_usize, none.faces.len());
        let shuffled = (
            Just(none.vertices).prop_shuffle(),
            Just(none.faces).prop_shuffle(),
        );
        let relabelling =
            (shuffled, turns, any::<bool>()).prop_map(|((vertices, faces), turns, reversed)| {
                Relabelling {
                    vertices,
                    faces,
                    turns,
                    reversed,
                }
            });
        (Just(planted), relabelling)
    })
}

#[test]
fn symmetry() {
    for_all_schemes(
        schemes(),
        |scheme| relabelled((scheme.meshes)()),
        |scheme, step, (Planted { mesh, .. }, relabelling)| {
            let sides = shown(mesh);
            let other = relabelling.apply(mesh);
            let (refined, other_refined) = match (step(mesh), step(&other)) {
                (Ok(refined), Ok(other)) => (refined, other),
                (Err(error), _) | (_, Err(error)) => return refused(sides, &error),
            };
            let names = |labels: &Relabelling, mesh: &Space| {
                labels.names(scheme.refinement, mesh.connectivity())
            };
            let none = Relabelling::none(mesh.connectivity());
            let (points, faces) = by_name(&refined, &names(&none, mesh), false);
            let (other_points, other_faces) = by_name(
                &other_refined,
                &names(relabelling, &other),
                relabelling.reversed,
            );
            let all = |points: &BTreeMap<Name, Place>| {
                coordinates(&points.values().copied().collect::<Vec<_>>())
            };
            sides
                .equal(
                    "the new points belong to the same elements, and the faces join the same points",
                    [points.keys().eq(other_points.keys()), faces == other_faces].map(f64::from),
                    [1.0, 1.0],
                    Rounding::none(),
                )
                .equal(
                    "the new points",
                    all(&points),
                    all(&other_points),
                    Rounding::new(2 * ROUNDINGS, WEIGHTS * largest(mesh)),
                )
        },
        &[
            ("the last goes to the first", mutants::last_towards_first),
            ("a face is lost", mutants::face_lost),
        ],
    );
}
