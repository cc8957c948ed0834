//! Properties of Kobbelt's scheme on random points.

use cagd::subdivision::{CatmullClark, Kobbelt, SurfaceScheme, kobbelt_virtual_point, laws};
use proptest::prelude::*;

use super::catmull_clark::{CASES, Place, Refine, closed_meshes, grids, places};
use crate::generators::for_all_of;
use crate::support::mutants::subdivision::kobbelt as mutants;
use crate::support::{holds, rejects};

#[test]
fn kobbelt() {
    let law = |implementation: fn(&[Place], &[Place]) -> Place| {
        let stars = (3..=12usize).prop_flat_map(|n| (places(n), places(n)));
        for_all_of(CASES, stars, |(neighbours, opposite)| {
            laws::kobbelt(implementation, neighbours, opposite)
        })
    };
    holds(law(kobbelt_virtual_point));
    rejects("one fifth", law(mutants::one_fifth));
    rejects("opposite by number", law(mutants::opposite_by_number));
    rejects("reflected", law(mutants::reflected));
    rejects("one face early", law(mutants::opposite_one_early));
}

#[test]
fn kobbelt_tensor_product() {
    let law = |implementation: Refine| {
        for_all_of(CASES, grids(), |(columns, rows, points)| {
            laws::kobbelt_tensor_product(implementation, *columns, *rows, points)
        })
    };
    holds(law(|mesh| Kobbelt.refine(mesh)));
    rejects("midpoints", law(mutants::midpoints));
    rejects("approximating", law(mutants::approximating));
}

#[test]
fn kobbelt_properties() {
    let law = |implementation: Refine| {
        // Two splits make quadrilaterals with at most one extraordinary vertex each.
        let split = closed_meshes()
            .prop_map(|mesh| CatmullClark.refine_times(&mesh, 2).expect("a closed mesh"));
        for_all_of(CASES / 2, split, |mesh| {
            laws::kobbelt_properties(implementation, mesh)
        })
    };
    holds(law(|mesh| Kobbelt.refine(mesh)));
    rejects("approximating", law(mutants::approximating));
}
