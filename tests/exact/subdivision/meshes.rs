//! The counts of elements, for solids, tori, plates with holes and discs.

use cagd::scalar::BigRational;
use cagd::subdivision::{HalfEdgeMesh, Refinement, laws, solids};

use crate::inputs::for_each;
use crate::support::mutants::subdivision::meshes as mutants;
use crate::support::{holds, rejects};

fn meshes() -> Vec<HalfEdgeMesh> {
    type Q = BigRational;
    let mut meshes = vec![
        solids::tetrahedron::<Q>().connectivity().clone(),
        solids::octahedron::<Q>().connectivity().clone(),
        solids::cube::<Q>().connectivity().clone(),
        solids::icosahedron::<f64>().connectivity().clone(),
        solids::grid::<Q>(3, 2).connectivity().clone(),
        solids::torus_triangles(4, 5),
        solids::torus_quadrilaterals(3, 4),
    ];
    meshes.extend((0..=3).map(|holes| solids::plate_with_holes::<Q>(holes).connectivity().clone()));
    meshes.extend((3..=12).flat_map(|k| [solids::triangle_fan(k), solids::quadrilateral_fan(k)]));
    meshes
}

#[test]
fn element_counts() {
    type Counts = fn(Refinement, &HalfEdgeMesh) -> Option<[usize; 3]>;
    let law = |implementation: Counts| {
        for_each(meshes(), |mesh| {
            laws::element_counts::<BigRational>(implementation, mesh)
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
