//! Kobbelt's scheme over rationals: its weights are rational at every valence.

use cagd::scalar::BigRational;
use cagd::subdivision::{
    CatmullClark, Kobbelt, Mesh, SurfaceScheme, kobbelt_virtual_point, laws, solids,
};

use super::catmull_clark::connectivities;
use crate::inputs::{for_each, integer, ratio};
use crate::support::mutants::subdivision::kobbelt as mutants;
use crate::support::{holds, rejects};

type Exact = BigRational;

/// Unit values at each neighbour and each opposite vertex, for the valences 3 to 12.
fn stars() -> impl Iterator<Item = [Vec<Exact>; 2]> {
    (3..=12).flat_map(|n| {
        (0..2 * n).map(move |one| {
            let list = |first: usize| (first..first + n).map(|i| integer(i64::from(i == one)));
            [list(0).collect(), list(n).collect()]
        })
    })
}

#[test]
fn kobbelt() {
    let law = |implementation: fn(&[Exact], &[Exact]) -> Exact| {
        for_each(stars(), |[neighbours, opposite]| {
            laws::kobbelt(implementation, neighbours, opposite)
        })
    };
    holds(law(kobbelt_virtual_point));
    rejects("one fifth", law(mutants::one_fifth));
    rejects("opposite by number", law(mutants::opposite_by_number));
    rejects("reflected", law(mutants::reflected));
    rejects("one face early", law(mutants::opposite_one_early));
}

/// With the factor 1/5 the two ways differ by (q₂ − q₋₂)/320.
#[test]
fn another_factor_leaves_a_difference() {
    for n in [3, 5, 6] {
        let neighbours = vec![integer(0); n];
        let opposite: Vec<Exact> = (0..n).map(|j| integer((j * j) as i64)).collect();
        let sides = laws::kobbelt(mutants::one_fifth, &neighbours, &opposite);
        let reading = sides.readings().next().expect("a claim");
        let difference = reading.left[0].clone() - reading.right[0].clone();
        let ends = opposite[2 % n].clone() - opposite[n - 2].clone();
        assert_eq!(difference, ends * ratio(1, 320));
    }
}

#[test]
fn kobbelt_tensor_product() {
    let law = |implementation: fn(&Mesh<Exact>) -> laws::Refined<Exact>| {
        let inputs = (0..30).map(|one| (0..30).map(|i| integer(i64::from(i == one))).collect());
        for_each(inputs, |points: &Vec<Exact>| {
            laws::kobbelt_tensor_product(implementation, 6, 5, points)
        })
    };
    holds(law(|mesh| Kobbelt.refine(mesh)));
    rejects("midpoints", law(mutants::midpoints));
    rejects("approximating", law(mutants::approximating));
}

/// Constants and, around a vertex of any valence, the plane: every rule is an affine combination.
#[test]
fn kobbelt_properties() {
    let law = |implementation: fn(&Mesh<Exact>) -> laws::Refined<Exact>| {
        let closed = connectivities().into_iter().filter(|mesh| mesh.is_closed());
        let meshes = closed.map(|mesh| {
            let values = mesh.vertices().map(|v| ratio(1, v.index() as i64 + 1));
            let mesh = Mesh::new(mesh.clone(), values.collect()).expect("a value for each vertex");
            // The first split makes quadrilaterals, the second separates extraordinary vertices.
            CatmullClark.refine_times(&mesh, 2).expect("a closed mesh")
        });
        for_each(meshes, |mesh| {
            laws::kobbelt_properties(implementation, mesh)
        })
    };
    holds(law(|mesh| Kobbelt.refine(mesh)));
    rejects("approximating", law(mutants::approximating));

    let flat = CatmullClark
        .refine(&solids::plate_with_holes::<Exact>(2))
        .expect("a closed mesh");
    let ones = flat.map(|_| integer(1)).expect("ones are finite");
    let refined = Kobbelt
        .refine(&ones)
        .expect("one extraordinary vertex a face");
    assert!(refined.points().iter().all(|x| *x == integer(1)));
}
