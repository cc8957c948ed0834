//! Doo–Sabin subdivision over rationals, where the cosines are: faces with 3, 4 and 6 sides.

use cagd::scalar::BigRational;
use cagd::subdivision::{
    CosineError, DooSabin, HalfEdgeMesh, Mesh, SurfaceScheme, doo_sabin_face, laws,
};

use super::catmull_clark::{connectivities, units};
use crate::inputs::{for_each, integer};
use crate::support::mutants::subdivision::doo_sabin as mutants;
use crate::support::{holds, rejects};

type Exact = BigRational;
type Refine = fn(&Mesh<Exact>) -> laws::Refined<Exact>;

#[test]
fn doo_sabin() {
    let law = |implementation: Refine| {
        let meshes = connectivities();
        for_each(meshes.iter().flat_map(units), |mesh| {
            laws::doo_sabin(implementation, mesh)
        })
    };
    holds(law(|mesh| DooSabin.refine(mesh)));
    rejects("half way to the centroid", law(mutants::mesh_half_way));
    rejects("next corner", law(mutants::mesh_next_corner));
    rejects("no vertex faces", law(mutants::vertex_faces_forgotten));
}

#[test]
fn doo_sabin_properties() {
    type Face = fn(&[Exact]) -> Result<Vec<Exact>, CosineError>;
    let law = |implementation: Face| {
        let inputs = [3, 4, 6].into_iter().flat_map(|k| {
            (0..k).map(move |one| (0..k).map(|i| integer(i64::from(i == one))).collect())
        });
        for_each(inputs, |points: &Vec<Exact>| {
            laws::doo_sabin_properties(implementation, points)
        })
    };
    holds(law(doo_sabin_face));
    rejects(
        "half way to the centroid",
        law(mutants::half_way_to_the_centroid),
    );
    rejects("next corner", law(mutants::next_corner));
    rejects("the quarter forgotten", law(mutants::quarter_forgotten));
}

#[test]
fn doo_sabin_chaikin() {
    let law = |implementation: Refine| {
        let inputs = (0..20).map(|one| (0..20).map(|i| integer(i64::from(i == one))).collect());
        for_each(inputs, |points: &Vec<Exact>| {
            laws::doo_sabin_chaikin(implementation, 5, 4, points)
        })
    };
    holds(law(|mesh| DooSabin.refine(mesh)));
    rejects("half way to the centroid", law(mutants::mesh_half_way));
    rejects("next corner", law(mutants::mesh_next_corner));
}

/// After one step all valences are 4, and the faces that are no quadrilaterals are as many as claimed.
#[test]
fn the_number_of_extraordinary_faces_stays() {
    let rational = |mesh: &&HalfEdgeMesh| {
        let sides = mesh.faces().map(|f| mesh.face_degree(f));
        let mut all = sides.chain(mesh.vertices().map(|v| mesh.valence(v)));
        mesh.is_closed() && all.all(|number| [3, 4, 6].contains(&number))
    };
    let meshes = connectivities();
    let chosen: Vec<_> = meshes.iter().filter(rational).collect();
    assert!(chosen.len() >= 3, "tetrahedron, octahedron, cube");
    for mesh in chosen {
        let expected = mesh.faces().filter(|&f| mesh.face_degree(f) != 4).count()
            + mesh.vertices().filter(|&v| mesh.valence(v) != 4).count();
        let mut refined = units(mesh).next().expect("a vertex");
        for _ in 0..2 {
            refined = DooSabin.refine(&refined).expect("rational cosines");
            let new = refined.connectivity();
            assert!(new.vertices().all(|v| new.valence(v) == 4));
            let others = new.faces().filter(|&f| new.face_degree(f) != 4).count();
            assert_eq!(others, expected);
        }
    }
    // Faces with five corners have irrational weights.
    let five = HalfEdgeMesh::from_faces(5, &[[0, 1, 2, 3, 4]]);
    let five = Mesh::new(five.expect("a pentagon"), vec![integer(0); 5]).expect("five values");
    let error = DooSabin.refine(&five).expect_err("cos(2π/5) is irrational");
    assert!(error.to_string().contains("/5"), "{error}");
}
