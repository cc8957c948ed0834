//! Properties of the modified Butterfly scheme.

use cagd::subdivision::{
    Butterfly, CosineError, Fan, FanNet, Mesh, SurfaceScheme, butterfly_cosine_formula,
    butterfly_star_weights, laws,
};

use super::catmull_clark::CASES;
use super::loop_scheme::Place;
use super::meshes::triangle_meshes;
use crate::generators::{for_all, for_all_of};
use crate::support::mutants::subdivision::butterfly as mutants;
use crate::support::{holds, rejects};

#[test]
fn modified_butterfly() {
    let law = |implementation: fn(&Mesh<Place>) -> laws::Refined<Place>| {
        for_all_of(CASES, triangle_meshes(), |planted| {
            laws::modified_butterfly(implementation, &planted.mesh)
        })
    };
    holds(law(|mesh| Butterfly::MODIFIED.refine(mesh)));
    rejects("the formula at 3 and 4", law(mutants::formula_everywhere));
    rejects("eight points", law(mutants::eight_points));
    rejects("midpoints", law(mutants::midpoints));
    rejects("boundary", law(mutants::midpoints_on_the_boundary));
    rejects("wings", law(mutants::wings_left_out));
}

fn regular(data: &[f64]) -> Vec<f64> {
    let fan = Fan::new(FanNet::Triangles, 6, 2).expect("a small fan");
    fan.refine(&Butterfly::MODIFIED, data).expect("valence 6")
}

#[test]
fn modified_butterfly_properties() {
    type Star = fn(usize) -> Result<Vec<f64>, CosineError>;
    let law = |star: Star, regular: fn(&[f64]) -> Vec<f64>| {
        for_all(3..=12usize, |&k| {
            laws::modified_butterfly_properties(star, regular, k)
        })
    };
    holds(law(butterfly_star_weights, regular));
    rejects("formula at 3 and 4", law(butterfly_cosine_formula, regular));
    rejects("one late", law(mutants::one_neighbour_late, regular));
    rejects("equal", law(mutants::equal_weights, regular));
    rejects("constant", law(butterfly_star_weights, mutants::constant));
}
