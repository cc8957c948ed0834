//! Properties of Doo–Sabin subdivision on random points.

use cagd::subdivision::{CosineError, DooSabin, SurfaceScheme, doo_sabin_face, laws};
use proptest::prelude::*;

use super::catmull_clark::{CASES, Place, Refine, grids, meshes, places};
use crate::generators::for_all_of;
use crate::support::mutants::subdivision::doo_sabin as mutants;
use crate::support::{holds, rejects};

#[test]
fn doo_sabin() {
    let law = |implementation: Refine| {
        for_all_of(CASES, meshes(), |mesh| {
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
    let law = |implementation: fn(&[Place]) -> Result<Vec<Place>, CosineError>| {
        let faces = (3..=12usize).prop_flat_map(places);
        for_all_of(CASES, faces, |points| {
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
        for_all_of(CASES, grids(), |(columns, rows, points)| {
            laws::doo_sabin_chaikin(implementation, *columns, *rows, points)
        })
    };
    holds(law(|mesh| DooSabin.refine(mesh)));
    rejects("half way to the centroid", law(mutants::mesh_half_way));
    rejects("next corner", law(mutants::mesh_next_corner));
}
