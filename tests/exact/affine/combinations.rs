//! Sums of points, proved for up to 7 points.
//!
//! The claims are linear in the weights and in the coordinates, and each coordinate is by itself.
//! So points of the line prove them: one of them 1 and the others 0, and one weight 1 and the others 0.

use cagd::affine::{barycentre as library_barycentre, laws, point_seen_from, vector_seen_from};
use cagd::scalar::BigRational;

use crate::inputs::{for_each, integer, ratio};
use crate::support::mutants::affine::combinations as mutants;
use crate::support::{holds, rejects};

type Exact = BigRational;
type Terms = [(Exact, Exact)];

/// The largest number of points for which identities are proved.
const MAX_POINTS: usize = 7;

/// `length` numbers, of which number `one` is 1 and the others are 0.
fn unit(one: usize, length: usize) -> impl Iterator<Item = Exact> {
    (0..length).map(move |i| integer(i64::from(i == one)))
}

/// Points and two more, one of all these 1 and the others 0, with one weight 1 or, if `all_zero`, none.
fn unit_terms(all_zero: bool) -> impl Iterator<Item = (Vec<(Exact, Exact)>, Exact, Exact)> {
    (1..=MAX_POINTS).flat_map(move |count| {
        (0..count + usize::from(all_zero)).flat_map(move |heavy| {
            (0..count + 2).map(move |far| {
                let mut places = unit(far, count + 2);
                let terms = unit(heavy, count).zip(places.by_ref()).collect();
                let [first, second] = [(); 2].map(|()| places.next().expect("two more places"));
                (terms, first, second)
            })
        })
    })
}

/// Both sides are linear in the weights, and in the points and both origins together.
#[test]
fn point_arithmetic() {
    type PointFrom = fn(&Exact, &Terms) -> Exact;
    type VectorFrom = fn(&Exact, &Terms) -> Exact;
    let law = |point: PointFrom, vector: VectorFrom| {
        for_each(unit_terms(true), |(terms, origin, other)| {
            laws::point_arithmetic(point, vector, terms, [origin, other])
        })
    };
    holds(law(point_seen_from, vector_seen_from));
    rejects(
        "origin ignored",
        law(mutants::origin_ignored, vector_seen_from),
    );
    rejects(
        "origin not added",
        law(mutants::origin_not_added, vector_seen_from),
    );
    rejects(
        "points taken for vectors",
        law(point_seen_from, mutants::points_taken_for_vectors),
    );
}

/// Both sides are affine in the weights with sum 1, and linear in the points and the base together.
#[test]
fn combination_from_base_point() {
    let law = |implementation: fn(&Exact, &Terms) -> Exact| {
        for_each(unit_terms(false), |(terms, base, _)| {
            laws::combination_from_base_point(implementation, terms, base)
        })
    };
    holds(law(point_seen_from));
    rejects(
        "the last vector left out",
        law(mutants::last_vector_left_out),
    );
    rejects(
        "vectors from the first point",
        law(mutants::vectors_from_the_first),
    );
}

/// Checked for all weights −2 … 3 of three points: which have a barycentre, and where it is.
#[test]
fn barycentre() {
    let weights = (0..216).map(|k| [k / 36, k / 6 % 6, k % 6].map(|w| integer(w - 2)));
    let inputs: Vec<Vec<(Exact, Exact)>> = weights
        .map(|weights| std::iter::zip(weights, [ratio(1, 3), integer(-2), integer(5)]).collect())
        .collect();
    let law = |implementation: fn(&Terms) -> Option<Exact>| {
        for_each(&inputs, |masses| {
            laws::barycentre(implementation, masses, &ratio(-2, 7), (1, &ratio(3, 2)))
        })
    };
    holds(law(|masses| library_barycentre(masses).ok()));
    rejects("not divided", law(mutants::not_divided));
    rejects("divided by the count", law(mutants::divided_by_the_count));
    rejects("weights forgotten", law(mutants::weights_forgotten));
    rejects("signs forgotten", law(mutants::signs_forgotten));
    rejects(
        "a point without weight",
        law(mutants::first_point_without_weight),
    );
}
