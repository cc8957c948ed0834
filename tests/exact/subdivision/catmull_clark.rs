//! Catmull–Clark subdivision over rationals.
//!
//! All rules are linear in the points, so unit values at each vertex prove them for a connectivity.

use cagd::bspline::uniform_b_spline;
use cagd::scalar::BigRational;
use cagd::subdivision::{
    CatmullClark, Creases, EdgeId, HalfEdgeMesh, Mesh, SurfaceScheme, VertexId, laws, solids,
};

use crate::inputs::{for_each, integer, ratio};
use crate::support::mutants::subdivision::catmull_clark as mutants;
use crate::support::{Outcome, holds, rejects};

type Exact = BigRational;

/// The meshes with these faces and values 0 but for a single 1.
pub fn units(mesh: &HalfEdgeMesh) -> impl Iterator<Item = Mesh<Exact>> + '_ {
    mesh.vertices().map(|one| {
        let values = mesh.vertices().map(|v| integer(i64::from(v == one)));
        Mesh::new(mesh.clone(), values.collect()).expect("a value for each vertex")
    })
}

/// Closed meshes and meshes with boundary, of triangles, quadrilaterals and mixed faces, valences 3 to 7.
pub fn connectivities() -> Vec<HalfEdgeMesh> {
    let mixed = HalfEdgeMesh::from_faces(5, &[vec![0, 1, 2, 3], vec![0, 4, 1]]);
    vec![
        solids::tetrahedron::<Exact>().connectivity().clone(),
        solids::octahedron::<Exact>().connectivity().clone(),
        solids::cube::<Exact>().connectivity().clone(),
        solids::plate_with_holes::<Exact>(1).connectivity().clone(),
        solids::grid::<Exact>(3, 2).connectivity().clone(),
        solids::quadrilateral_fan(5),
        solids::triangle_fan(7),
        mixed.expect("a triangle beside a quadrilateral"),
    ]
}

/// Closed meshes of quadrilaterals in which the faces of one vertex are known: fans, split to separate their valences.
fn stars() -> impl Iterator<Item = (Mesh<Exact>, VertexId)> {
    (3..=12).flat_map(|valence| {
        let fan = solids::quadrilateral_fan(valence);
        units(&fan)
            .map(|mesh| (mesh, VertexId(0)))
            .collect::<Vec<_>>()
    })
}

#[test]
fn catmull_clark() {
    let law = |implementation: fn(&Mesh<Exact>) -> laws::Refined<Exact>| -> Outcome {
        let meshes = connectivities();
        for_each(meshes.iter().flat_map(units), |mesh| {
            laws::catmull_clark(implementation, mesh)
        })
    };
    holds(law(|mesh| CatmullClark.refine(mesh)));
    rejects("midpoints", law(mutants::midpoints_for_edge_points));
    rejects("vertices stay", law(mutants::vertices_stay));
    rejects("valence 4", law(mutants::valence_four_everywhere));
    rejects("edges forgotten", law(mutants::edges_forgotten));
}

#[test]
fn catmull_clark_properties() {
    let law = |implementation: fn(&Mesh<Exact>) -> laws::Refined<Exact>| {
        let sizes = [[3, 3], [4, 3], [5, 4]];
        let inputs = sizes.into_iter().flat_map(|[columns, rows]| {
            let unit = move |one| (0..columns * rows).map(move |i| integer(i64::from(i == one)));
            (0..columns * rows).map(move |one| (columns, rows, unit(one).collect::<Vec<_>>()))
        });
        for_each(inputs, |(columns, rows, points)| {
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
    type Limit = fn(&Mesh<Exact>, VertexId) -> Result<Exact, cagd::subdivision::SchemeError>;
    let law = |implementation: Limit| {
        for_each(stars(), |(mesh, v)| {
            laws::catmull_clark_limit(implementation, mesh, *v)
        })
    };
    holds(law(|mesh, v| CatmullClark.limit_position(mesh, v)));
    rejects("the vertex itself", law(mutants::limit_is_the_vertex));
    rejects("one step", law(mutants::limit_after_one_step));
    rejects("valence 4", law(mutants::limit_of_valence_four));
}

/// Creases on every kind of mesh: a loop around a face, a path that ends, a crossing, a corner.
pub fn creased() -> Vec<(HalfEdgeMesh, Creases)> {
    let mut inputs = vec![];
    for mesh in connectivities() {
        let around = mesh.face_half_edges(mesh.faces().next().expect("a face"));
        let around: Vec<EdgeId> = around.map(|h| mesh.edge(h)).collect();
        let star: Vec<EdgeId> = mesh
            .vertex_ring(VertexId(0))
            .map(|h| mesh.edge(h))
            .collect();
        let sets = [
            (around.clone(), vec![]),
            (vec![around[0]], vec![]),
            (star, vec![]),
            (around, vec![VertexId(1)]),
        ];
        for (sharp, corners) in sets {
            let creases = Creases::new(&mesh, sharp, corners).expect("they are of the mesh");
            inputs.push((mesh.clone(), creases));
        }
    }
    inputs
}

#[test]
fn creases() {
    type Refine = fn(
        &Mesh<Exact>,
        &Creases,
    ) -> Result<(Mesh<Exact>, Creases), cagd::subdivision::SchemeError>;
    let law = |implementation: Refine| {
        let inputs = creased().into_iter().flat_map(|(mesh, creases)| {
            let meshes: Vec<_> = units(&mesh).collect();
            meshes.into_iter().map(move |mesh| (mesh, creases.clone()))
        });
        for_each(inputs, |(mesh, creases)| {
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

/// On a regular torus the refined spike has the limits N³(x)·N³(y) at the points of the finer lattice.
#[test]
fn a_spike_becomes_the_tensor_product_b_spline() {
    let n = 8;
    let torus = solids::torus_quadrilaterals(n, n);
    let centre = 4 * n + 4;
    let heights = (0..n * n).map(|v| integer(i64::from(v == centre)));
    let spike = Mesh::new(torus, heights.collect()).expect("finite heights");
    let refined = CatmullClark.refine(&spike).expect("valence 4");
    let old = spike.connectivity();
    // Places as multiples of 1/4, relative to the spike; no old face is taken that lies across the border of the square.
    let place = |v: VertexId| [v.index() % n, v.index() / n].map(|k| 4 * (k as i64 - 4));
    let mean = |vertices: &[VertexId]| {
        let sum = |k: usize| vertices.iter().map(|&v| place(v)[k]).sum::<i64>();
        [0, 1].map(|k| sum(k) / vertices.len() as i64)
    };
    let mut groups: Vec<Vec<VertexId>> = old.vertices().map(|v| vec![v]).collect();
    groups.extend(old.edges().map(|e| old.edge_vertices(e).to_vec()));
    groups.extend(old.faces().map(|f| old.face_vertices(f).collect()));
    let mut compared = 0;
    for (vertex, group) in groups.iter().enumerate() {
        let near = |k: usize| {
            let along = group.iter().map(|&v| place(v)[k]);
            along.clone().max() <= along.min().map(|least| least + 4)
        };
        if !(near(0) && near(1)) {
            continue;
        }
        let limit: Exact = CatmullClark
            .limit_position(&refined, VertexId(vertex as u32))
            .expect("valence 4");
        // The knots of N³ begin at 0, so its centre is 2.
        let [x, y] = mean(group).map(|quarters| uniform_b_spline(3, ratio(quarters + 8, 4)));
        assert_eq!(limit, x * y, "at {:?}/4", mean(group));
        compared += 1;
    }
    assert_eq!(compared, 15 * 15);
}
