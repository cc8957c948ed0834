//! The modified Butterfly scheme over rationals, at the valences 3, 4 and 6.

use cagd::affine::Point;
use cagd::scalar::BigRational;
use cagd::subdivision::{
    Butterfly, CosineError, Fan, FanNet, HalfEdgeMesh, Mesh, SubdivisionMatrix, SurfaceScheme,
    butterfly_cosine_formula, butterfly_star_weights, laws,
};

use super::loop_scheme::{meshes, unit_points};
use crate::inputs::{for_each, integer, ratio};
use crate::support::mutants::subdivision::butterfly as mutants;
use crate::support::{holds, rejects};

type Place = Point<BigRational, 3>;

/// The meshes of Loop's tests, and strips of a regular mesh with unit points: wings are missing at one side and at both.
fn open_and_closed() -> impl Iterator<Item = Mesh<Place>> {
    let strips = (1..=3).flat_map(|rows| {
        let cells = (0..rows).flat_map(|j| (0..4).map(move |i| 5 * j + i));
        let halves = cells.flat_map(|v| [[v, v + 1, v + 6], [v, v + 6, v + 5]]);
        let strip = HalfEdgeMesh::from_faces(5 * (rows as usize + 1), &halves.collect::<Vec<_>>());
        unit_points(strip.expect("a strip"))
    });
    meshes().into_iter().chain(strips)
}

#[test]
fn modified_butterfly() {
    let law = |implementation: fn(&Mesh<Place>) -> laws::Refined<Place>| {
        for_each(open_and_closed(), |mesh| {
            laws::modified_butterfly(implementation, mesh)
        })
    };
    holds(law(|mesh| Butterfly::MODIFIED.refine(mesh)));
    rejects("the formula at 3 and 4", law(mutants::formula_everywhere));
    rejects("eight points", law(mutants::eight_points));
    rejects("midpoints", law(mutants::midpoints));
    rejects("boundary", law(mutants::midpoints_on_the_boundary));
    rejects("wings", law(mutants::wings_left_out));
}

fn regular(data: &[BigRational]) -> Vec<BigRational> {
    let fan = Fan::new(FanNet::Triangles, 6, 2).expect("a small fan");
    fan.refine(&Butterfly::MODIFIED, data).expect("valence 6")
}

#[test]
fn modified_butterfly_properties() {
    type Star = fn(usize) -> Result<Vec<BigRational>, CosineError>;
    let law = |star: Star, regular: fn(&[BigRational]) -> Vec<BigRational>| {
        for_each([3, 4, 6], |&k| {
            laws::modified_butterfly_properties(star, regular, k)
        })
    };
    holds(law(butterfly_star_weights, regular));
    rejects("formula at 3 and 4", law(butterfly_cosine_formula, regular));
    rejects("one late", law(mutants::one_neighbour_late, regular));
    rejects("equal", law(mutants::equal_weights, regular));
    rejects("constant", law(butterfly_star_weights, mutants::constant));
}

/// With the right weights 1/2 is a double eigenvalue with two eigenvectors; with the formula it is triple at valence 4, and 3/4 double at 3.
#[test]
fn eigenvalues_at_the_valences_three_and_four() {
    let matrix = |scheme, valence| {
        SubdivisionMatrix::<BigRational>::extract(&scheme, FanNet::Triangles, valence, 2)
            .expect("two rings of a rational valence")
    };
    for valence in [3, 4, 6] {
        let right = matrix(Butterfly::MODIFIED, valence);
        assert_eq!(right.multiplicity(&integer(1)), 1);
        assert_eq!(right.multiplicity(&ratio(1, 2)), 2);
        assert_eq!(right.eigenspace_dimension(&ratio(1, 2)), 2);
    }
    assert_eq!(
        matrix(Butterfly::FORMULA_ONLY, 3).multiplicity(&ratio(3, 4)),
        2
    );
    assert_eq!(
        matrix(Butterfly::FORMULA_ONLY, 4).multiplicity(&ratio(1, 2)),
        3
    );
    // The eight points alone: what comes after 1 is 1/4, three times at least.
    let unmodified = matrix(Butterfly::UNMODIFIED, 3);
    assert_eq!(unmodified.multiplicity(&ratio(1, 2)), 0);
    assert!(unmodified.multiplicity(&ratio(1, 4)) > 2);
}
