//! Properties of Catmull–Clark subdivision on random points.

use cagd::affine::Point;
use cagd::subdivision::{
    CatmullClark, Creases, HalfEdgeMesh, Mesh, SchemeError, SurfaceScheme, VertexId, laws, solids,
};
use proptest::prelude::*;

use super::creases::creased;
use crate::generators::{for_all_of, scale};
use crate::support::mutants::subdivision::catmull_clark as mutants;
use crate::support::{Outcome, holds, rejects};

pub type Place = Point<f64, 3>;
pub type Refine = fn(&Mesh<Place>) -> laws::Refined<Place>;

/// A mesh is much work for a law.
pub const CASES: u32 = 64;

/// Points in space, also repeated, huge and tiny ones.
pub fn places(count: usize) -> impl Strategy<Value = Vec<Place>> {
    let coordinates = prop_oneof![2 => -8.0..8.0, 1 => (-2i32..=2).prop_map(f64::from)];
    let place = prop::array::uniform3(coordinates);
    (prop::collection::vec(place, count), scale()).prop_map(|(places, scale)| {
        let scaled = |place: [f64; 3]| Point::new(place.map(|x| x * scale));
        places.into_iter().map(scaled).collect()
    })
}

/// Random points on this connectivity.
pub fn placed(mesh: HalfEdgeMesh) -> impl Strategy<Value = Mesh<Place>> {
    places(mesh.vertex_count())
        .prop_map(move |points| Mesh::new(mesh.clone(), points).expect("finite points"))
}

/// Closed meshes of genus 0 to 3 with triangles, quadrilaterals or pentagons, valences 3 to 5.
pub fn closed_meshes() -> impl Strategy<Value = Mesh<Place>> {
    let dodecahedron = dual(solids::icosahedron::<f64>().connectivity());
    let solids = vec![
        solids::tetrahedron::<f64>().connectivity().clone(),
        solids::octahedron::<f64>().connectivity().clone(),
        solids::cube::<f64>().connectivity().clone(),
        dodecahedron,
        solids::torus_quadrilaterals(4, 3),
        solids::plate_with_holes::<f64>(2).connectivity().clone(),
        solids::plate_with_holes::<f64>(3).connectivity().clone(),
    ];
    prop::sample::select(solids).prop_flat_map(placed)
}

/// The faces of a closed mesh as vertices, its vertices as faces.
fn dual(mesh: &HalfEdgeMesh) -> HalfEdgeMesh {
    let around = |v| {
        let ring = mesh.vertex_ring(v).filter_map(|h| mesh.face(h));
        ring.map(|f| f.0).collect::<Vec<u32>>()
    };
    let faces: Vec<Vec<u32>> = mesh.vertices().map(around).collect();
    HalfEdgeMesh::from_faces(mesh.face_count(), &faces).expect("the dual of a closed mesh")
}

/// Fans of valence 3 to 12 and grids, which have a boundary.
pub fn open_meshes() -> impl Strategy<Value = Mesh<Place>> {
    let fans = (3..=12usize).prop_map(solids::quadrilateral_fan);
    let triangles = (3..=12usize).prop_map(solids::triangle_fan);
    let grids = (1..4usize, 1..4usize)
        .prop_map(|(columns, rows)| solids::grid::<f64>(columns, rows).connectivity().clone());
    prop_oneof![fans, triangles, grids].prop_flat_map(placed)
}

/// Closed and open meshes.
pub fn meshes() -> impl Strategy<Value = Mesh<Place>> {
    prop_oneof![closed_meshes(), open_meshes()]
}

/// A vertex of valence 3 to 12 in quadrilaterals.
fn fans() -> impl Strategy<Value = Mesh<Place>> {
    (3..=12usize).prop_flat_map(|valence| placed(solids::quadrilateral_fan(valence)))
}

#[test]
fn catmull_clark() {
    let law = |implementation: Refine| -> Outcome {
        for_all_of(CASES, meshes(), |mesh| {
            laws::catmull_clark(implementation, mesh)
        })
    };
    holds(law(|mesh| CatmullClark.refine(mesh)));
    rejects("midpoints", law(mutants::midpoints_for_edge_points));
    rejects("vertices stay", law(mutants::vertices_stay));
    rejects("valence 4", law(mutants::valence_four_everywhere));
    rejects("edges forgotten", law(mutants::edges_forgotten));
}

/// Closed grids of quadrilaterals.
pub fn grids() -> impl Strategy<Value = (usize, usize, Vec<Place>)> {
    (3..7usize, 3..7usize).prop_flat_map(|(columns, rows)| {
        places(columns * rows).prop_map(move |points| (columns, rows, points))
    })
}

#[test]
fn catmull_clark_properties() {
    let law = |implementation: Refine| {
        for_all_of(CASES, grids(), |(columns, rows, points)| {
            laws::catmull_clark_properties(implementation, *columns, *rows, points)
        })
    };
    holds(law(|mesh| CatmullClark.refine(mesh)));
    rejects("midpoints", law(mutants::midpoints_for_edge_points));
    rejects("vertices stay", law(mutants::vertices_stay));
    rejects("edges forgotten", law(mutants::edges_forgotten));
}

#[test]
fn catmull_clark_limit() {
    type Limit = fn(&Mesh<Place>, VertexId) -> Result<Place, SchemeError>;
    let law = |implementation: Limit| {
        for_all_of(CASES, fans(), |mesh| {
            laws::catmull_clark_limit(implementation, mesh, VertexId(0))
        })
    };
    holds(law(|mesh, v| CatmullClark.limit_position(mesh, v)));
    rejects("the vertex itself", law(mutants::limit_is_the_vertex));
    rejects("one step", law(mutants::limit_after_one_step));
    rejects("valence 4", law(mutants::limit_of_valence_four));
}

#[test]
fn catmull_clark_tangents() {
    type Vectors = [cagd::affine::Vector<f64, 3>; 2];
    let law = |implementation: fn(&Mesh<Place>, VertexId) -> Result<Vectors, SchemeError>| {
        for_all_of(CASES, fans(), |mesh| {
            laws::catmull_clark_tangents(implementation, mesh, VertexId(0))
        })
    };
    holds(law(|mesh, v| CatmullClark.limit_tangents(mesh, v)));
    rejects(
        "no opposite vertices",
        law(mutants::tangents_without_opposite),
    );
}

#[test]
fn creases() {
    type Refine = fn(&Mesh<Place>, &Creases) -> Result<(Mesh<Place>, Creases), SchemeError>;
    let law = |implementation: Refine| {
        for_all_of(CASES, creased(meshes()), |(mesh, creases)| {
            laws::creases(implementation, mesh, creases)
        })
    };
    holds(law(|mesh, creases| {
        CatmullClark.refine_creased(mesh, creases)
    }));
    rejects("tags ignored", law(mutants::tags_ignored));
    rejects("tags lost", law(mutants::tags_lost));
    rejects("crease vertices stay", law(mutants::crease_vertices_stay));
}
