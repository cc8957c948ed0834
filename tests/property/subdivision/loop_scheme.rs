//! Properties of Loop's scheme.

use cagd::affine::{Point, Vector};
use cagd::law::{Rounding, Sides};
use cagd::subdivision::{
    Butterfly, FanNet, HalfEdgeMesh, LatticeMask, Loop, Mesh, SchemeError, SubdivisionMatrix,
    SurfaceScheme, VertexId, box_spline_222, laws, loop_lattice_mask, solids,
};
use proptest::prelude::*;

use super::catmull_clark::{CASES, placed};
use crate::generators::{for_all, for_all_of};
use crate::support::mutants::subdivision::loop_scheme as mutants;
use crate::support::{holds, rejects};

/// Places in and around the support of the box spline, often on its grid.
fn place() -> impl Strategy<Value = [f64; 2]> {
    let coordinate = || {
        prop_oneof![
            2 => (-5i32..=5).prop_map(|k| f64::from(k) / 2.0),
            3 => -2.5..2.5,
        ]
    };
    prop_oneof![
        4 => [coordinate(), coordinate()],
        1 => coordinate().prop_map(|x| [x, x]),
    ]
}

#[test]
fn loop_box_spline() {
    type Spline = fn(&[f64; 2]) -> f64;
    let law = |mask: LatticeMask<f64>, spline: Spline| {
        for_all(place(), |x| laws::loop_box_spline(&mask, spline, x))
    };
    let mask = || loop_lattice_mask().expect("valence 6");
    holds(law(mask(), box_spline_222));
    rejects("linear", law(mutants::linear_mask(), box_spline_222));
    rejects(
        "edge weights swapped",
        law(mutants::edge_weights_swapped(), box_spline_222),
    );
    rejects("other diagonal", law(mask(), mutants::other_diagonal));
    rejects("not centred", law(mask(), mutants::not_centred));
    rejects("piecewise linear", law(mask(), mutants::hat));
}

pub type Place = Point<f64, 3>;

/// Closed triangle meshes of genus 0 to 3 with valences 3 to 8.
pub fn closed_meshes() -> impl Strategy<Value = Mesh<Place>> {
    let plates = (2..=3).map(|holes| {
        let plate = solids::triangulated(&solids::plate_with_holes::<f64>(holes));
        plate
            .expect("the diagonals of squares are no edges")
            .connectivity()
            .clone()
    });
    let mut all: Vec<HalfEdgeMesh> = plates.collect();
    all.extend([
        solids::tetrahedron::<f64>().connectivity().clone(),
        solids::octahedron::<f64>().connectivity().clone(),
        solids::icosahedron::<f64>().connectivity().clone(),
        solids::torus_triangles(3, 4),
    ]);
    prop::sample::select(all).prop_flat_map(placed)
}

/// Closed meshes and fans of valence 3 to 12.
fn meshes() -> impl Strategy<Value = Mesh<Place>> {
    let fans = (3..=12usize)
        .prop_map(solids::triangle_fan)
        .prop_flat_map(placed);
    prop_oneof![closed_meshes(), fans]
}

#[test]
fn every_class_of_triangle_mesh_occurs() {
    let seen = std::cell::RefCell::new(std::collections::BTreeSet::new());
    holds(for_all(meshes(), |mesh| {
        let mesh = mesh.connectivity();
        let mut seen = seen.borrow_mut();
        seen.insert(format!("genus {}", mesh.genus()));
        seen.insert(format!("closed {}", mesh.is_closed()));
        seen.extend(
            mesh.vertices()
                .map(|v| format!("valence {}", mesh.valence(v))),
        );
        Sides::new("statistics").equal("always", [0.0], [0.0], Rounding::none())
    }));
    let seen = seen.into_inner();
    let expected = (0..=3).map(|genus| format!("genus {genus}"));
    let expected = expected.chain((3..=12).map(|k| format!("valence {k}")));
    for class in expected.chain(["closed true".into(), "closed false".into()]) {
        assert!(seen.contains(&class), "no mesh of the class «{class}»");
    }
}

#[test]
fn loop_rules() {
    let law = |implementation: fn(&Mesh<Place>) -> laws::Refined<Place>| {
        for_all_of(CASES, meshes(), |mesh| {
            laws::loop_rules(implementation, mesh)
        })
    };
    holds(law(|mesh| Loop.refine(mesh)));
    rejects("1/16 everywhere", law(mutants::regular_weights_everywhere));
    rejects("midpoints", law(mutants::midpoints));
}

#[test]
fn loop_properties() {
    let law = |scheme: fn(usize) -> SubdivisionMatrix<f64>| {
        for_all(3..=12usize, |&valence| {
            laws::loop_properties(&scheme(valence))
        })
    };
    holds(law(|valence| {
        SubdivisionMatrix::extract(&Loop, FanNet::Triangles, valence, 1).expect("one ring")
    }));
    rejects(
        "the Butterfly scheme",
        law(|valence| {
            SubdivisionMatrix::extract(&Butterfly::MODIFIED, FanNet::Triangles, valence, 2)
                .expect("two rings")
        }),
    );
}

#[test]
fn loop_limit() {
    type Limit = fn(&Mesh<Place>, VertexId) -> Result<Place, SchemeError>;
    type Tangents = fn(&Mesh<Place>, VertexId) -> Result<[Vector<f64, 3>; 2], SchemeError>;
    let law = |limit: Limit, tangents: Tangents| {
        for_all_of(CASES, meshes(), |mesh| {
            laws::loop_limit(|mesh| Loop.refine(mesh), limit, tangents, mesh)
        })
    };
    let (limit, tangents): (Limit, Tangents) = (
        |mesh, v| Loop.limit_point(mesh, v),
        |mesh, v| Loop.limit_tangents(mesh, v),
    );
    holds(law(limit, tangents));
    rejects("6 and 1 everywhere", law(mutants::regular_limit, tangents));
    rejects("one step", law(mutants::one_step, tangents));
    rejects("edges", law(limit, mutants::edges_as_tangents));
}
