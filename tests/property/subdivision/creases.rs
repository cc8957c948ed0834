//! Limit points of meshes with sharp edges.

use std::cell::RefCell;
use std::collections::BTreeMap;

use cagd::affine::Point;
use cagd::law::{Rounding, Sides};
use cagd::subdivision::{CatmullClark, Creases, EdgeId, Loop, SchemeError, VertexId, VertexRule};
use proptest::prelude::*;

use super::catmull_clark::CASES;
use super::meshes::{Planted, Space, quadrilateral_meshes, triangle_meshes};
use crate::generators::for_all_of;
use crate::support::mutants::subdivision::creases as mutants;
use crate::support::mutants::subdivision::creases::Limit;
use crate::support::{Outcome, holds, rejects};

type Refine = fn(&Space, &Creases) -> Result<(Space, Creases), SchemeError>;

/// Meshes with random tags: three edges of ten are sharp, one vertex of ten is a corner.
pub fn creased(meshes: impl Strategy<Value = Space>) -> impl Strategy<Value = (Space, Creases)> {
    meshes.prop_flat_map(|mesh| {
        let old = mesh.connectivity();
        let edges = prop::collection::vec(prop::bool::weighted(0.3), old.edge_count());
        let corners = prop::collection::vec(prop::bool::weighted(0.1), old.vertex_count());
        (Just(mesh), edges, corners).prop_map(|(mesh, edges, corners)| {
            let chosen = |list: &[bool]| {
                let numbers = list.iter().enumerate().filter(|(_, tag)| **tag);
                numbers.map(|(i, _)| i as u32).collect::<Vec<u32>>()
            };
            let sharp = chosen(&edges).into_iter().map(EdgeId);
            let corners = chosen(&corners).into_iter().map(VertexId);
            let creases = Creases::new(mesh.connectivity(), sharp, corners);
            (mesh, creases.expect("elements of the mesh"))
        })
    })
}

/// A step moves no limit, at vertices of all kinds; where a crease ends the limit is refused.
///
/// `occurred` counts the kinds of vertices.
fn limits_stay(
    refine: Refine,
    limit: Limit,
    mesh: &Space,
    creases: &Creases,
    occurred: &RefCell<BTreeMap<&str, usize>>,
) -> Sides<f64> {
    let old = mesh.connectivity();
    let (refined, finer) = refine(mesh, creases).expect("all valences have a rule");
    let coordinates = |p: &Point<f64, 3>| [p[0], p[1], p[2]];
    let all = mesh.points().iter().flat_map(coordinates);
    let largest = all.fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let (mut before, mut after, mut refused) = (vec![], vec![], vec![]);
    for v in old.vertices() {
        let sharp = old.vertex_ring(v).map(|h| old.edge(h));
        let sharp = sharp.filter(|&e| creases.is_sharp(old, e)).count();
        let kind = match (creases.rule(old, v), sharp) {
            (VertexRule::Smooth, 1) => "dart",
            (VertexRule::Smooth, _) => "smooth",
            (VertexRule::Crease(_), _) => "crease",
            (VertexRule::Corner, _) => "corner",
        };
        *occurred.borrow_mut().entry(kind).or_default() += 1;
        let found = limit(mesh, creases, v);
        if kind == "dart" {
            refused.push(f64::from(
                matches!(found, Err(SchemeError::CreaseEnd { vertex, .. }) if vertex == v),
            ));
            continue;
        }
        before.extend(found.map_or([f64::NAN; 3], |p| coordinates(&p)));
        after.extend(limit(&refined, &finer, v).map_or([f64::NAN; 3], |p| coordinates(&p)));
    }
    let count = refused.len();
    // With valences up to 12 a step has at most 40 roundings, a limit 40; all weights are positive and sum to 1.
    Sides::new(format!("faces {:?}, {creases:?}", old.face_lists()))
        .equal("limit points", before, after, Rounding::new(160, largest))
        .equal(
            "darts are refused",
            refused,
            vec![1.0; count],
            Rounding::none(),
        )
}

#[test]
fn limits_on_creases() {
    let occurred = RefCell::new(BTreeMap::new());
    let law = |refine: Refine, meshes: BoxedStrategy<Planted>, limit: Limit| -> Outcome {
        let meshes = creased(meshes.prop_map(|planted| planted.mesh));
        for_all_of(CASES / 2, meshes, |(mesh, creases)| {
            limits_stay(refine, limit, mesh, creases, &occurred)
        })
    };
    let triangles = |limit: Limit| {
        let refine: Refine = |mesh, creases| Loop.refine_creased(mesh, creases);
        law(refine, triangle_meshes().boxed(), limit)
    };
    let quadrilaterals = |limit: Limit| {
        let refine: Refine = |mesh, creases| CatmullClark.refine_creased(mesh, creases);
        law(refine, quadrilateral_meshes().boxed(), limit)
    };
    holds(triangles(|mesh, creases, v| {
        Loop.limit_point_creased(mesh, creases, v)
    }));
    rejects("tags ignored", triangles(mutants::loop_without_tags));
    rejects("the vertex itself", triangles(mutants::the_vertex_itself));
    holds(quadrilaterals(|mesh, creases, v| {
        CatmullClark.limit_position_creased(mesh, creases, v)
    }));
    rejects(
        "tags ignored",
        quadrilaterals(mutants::catmull_clark_without_tags),
    );
    rejects(
        "the vertex itself",
        quadrilaterals(mutants::the_vertex_itself),
    );
    let occurred = occurred.into_inner();
    for kind in ["smooth", "dart", "crease", "corner"] {
        assert!(
            occurred.get(kind).is_some_and(|&count| count > 20),
            "{kind}: {occurred:?}"
        );
    }
}
