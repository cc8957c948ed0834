//! Properties of affine combinations and barycentres.

use cagd::affine::{
    Affine, CombinationKind, Point, Vector, barycentre as library_barycentre, laws,
    point_seen_from, vector_seen_from,
};
use proptest::prelude::*;

use super::inputs::{any_sum, eighth, place, terms, vector};
use crate::generators::for_all;
use crate::support::mutants::affine::combinations as mutants;
use crate::support::{holds, rejects};

type Point2 = Point<f64, 2>;
type Terms = [(f64, Point2)];

#[test]
fn combinations() {
    let law = |implementation: fn(&Terms) -> Option<Point2>| {
        for_all((terms(any_sum()), vector()), |(terms, shift)| {
            laws::combinations(implementation, terms, shift)
        })
    };
    holds(law(|terms| Point::affine_combination(terms.to_vec()).ok()));
    rejects("any sum", law(mutants::weights_unchecked));
    rejects("divided by the sum", law(mutants::weights_normalised));
    rejects("last term dropped", law(mutants::last_term_dropped));
    rejects(
        "no negative weights",
        law(mutants::negative_weights_refused),
    );
    rejects(
        "the first takes the rest",
        law(mutants::first_takes_the_rest),
    );
}

/// Whole coordinates and weights in quarters, so that nothing is rounded; in half of the cases λ + μ = 1.
#[test]
fn line_through_two_points() {
    let tip = || [-4i32..=4, -4i32..=4].prop_map(|v| Vector::from(v.map(f64::from)));
    let pair = prop_oneof![
        4 => (tip(), tip()),
        1 => (tip(), -2i32..=2).prop_map(|(a, k)| (a, a * f64::from(k))),
    ];
    let weights = prop_oneof![
        (eighth(), eighth()),
        eighth().prop_map(|lambda| (lambda, 1.0 - lambda)),
    ];
    let law = |implementation: fn(&f64, &f64) -> CombinationKind| {
        for_all((&pair, &weights), |((a, b), (lambda, mu))| {
            laws::line_through_two_points(implementation, [a, b], [lambda, mu])
        })
    };
    holds(law(|lambda, mu| CombinationKind::of(&[*lambda, *mu])));
    rejects("signs alone", law(mutants::signs_alone));
    rejects("the segment for the line", law(mutants::segment_for_line));
    rejects("sums up to 1", law(mutants::sum_at_most_one));
}

#[test]
fn point_arithmetic() {
    type PointFrom = fn(&Point2, &Terms) -> Point2;
    type VectorFrom = fn(&Point2, &Terms) -> Vector<f64, 2>;
    let law = |point: PointFrom, vector: VectorFrom| {
        for_all((terms(any_sum()), place(), place()), |(terms, o, other)| {
            laws::point_arithmetic(point, vector, terms, [o, other])
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

/// The vector of a combination with sum 0 is the same for all origins, and the library gives it.
#[test]
fn vector_combinations() {
    holds(for_all((terms(Just(0.0)), place()), |(terms, origin)| {
        let library = |_: &Point2, terms: &Terms| {
            Point::vector_combination(terms.to_vec()).expect("the weights sum to 0")
        };
        laws::point_arithmetic(
            |origin: &Point2, terms| *origin + library(origin, terms),
            library,
            terms,
            [origin, origin],
        )
    }));
}

#[test]
fn combination_from_base_point() {
    let law = |implementation: fn(&Point2, &Terms) -> Point2| {
        for_all((terms(Just(1.0)), place()), |(terms, base)| {
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

#[test]
fn barycentre() {
    let sums = prop_oneof![3 => (1i32..=16).prop_map(|k| f64::from(k) / 8.0), 1 => any_sum()];
    let inputs = (
        terms(sums),
        eighth(),
        any::<prop::sample::Index>(),
        eighth(),
    );
    let law = |implementation: fn(&Terms) -> Option<Point2>| {
        for_all(&inputs, |(masses, factor, index, extra)| {
            let index = index.index(masses.len());
            laws::barycentre(implementation, masses, factor, (index, extra))
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

/// What is not finite, empty or of the wrong sum is refused with its place.
#[test]
fn bad_terms_are_named() {
    let p = Point::new([1.0, 2.0]);
    let nan = Point::new([f64::NAN, 2.0]);
    let message = |terms: &Terms| {
        let [affine, vector, balance] = [
            Point::affine_combination(terms.to_vec()).err(),
            Point::vector_combination(terms.to_vec()).err(),
            library_barycentre(terms).err(),
        ]
        .map(|error| error.map_or_else(String::new, |error| error.to_string()));
        [affine, vector, balance]
    };
    for text in message(&[]) {
        assert!(text.contains("at least one term"), "{text}");
    }
    for text in message(&[(1.0, p), (0.0, nan)]) {
        assert!(text.contains("term 1"), "{text}");
        assert!(text.contains("(NaN, 2)"), "{text}");
    }
    for text in message(&[(f64::INFINITY, p)]) {
        assert!(text.contains("term 0"), "{text}");
    }
    let [affine, vector, balance] = message(&[(1.0, p), (-1.0, p)]);
    assert!(affine.contains("must sum to 1, not to 0"), "{affine}");
    assert_eq!(vector, "");
    assert!(
        balance.contains("2 weights of a barycentre sum to 0"),
        "{balance}"
    );
    let [affine, vector, balance] = message(&[(0.5, p), (0.25, p)]);
    assert!(affine.contains("0.75"), "{affine}");
    assert!(vector.contains("must sum to 0, not to 0.75"), "{vector}");
    assert_eq!(balance, "");
    let far = Point::new([f64::MAX, 0.0]);
    let [.., balance] = message(&[(1.0, far), (1.0, Point::new([-f64::MAX, 0.0]))]);
    assert!(balance.contains("beyond the range"), "{balance}");
    let [.., balance] = message(&[(f64::MAX, p), (f64::MAX, p)]);
    assert!(balance.contains("beyond the range"), "{balance}");
}
