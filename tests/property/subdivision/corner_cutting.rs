//! Properties of corner cutting.

use cagd::subdivision::{ControlPolygon, SchemeKind, laws};
use proptest::prelude::*;

use super::polygons::{MAX_DEGREE, PlanePolygon, polygons};
use crate::generators::for_all;
use crate::support::mutants::subdivision::corner_cutting as mutants;
use crate::support::{holds, rejects};

type Step = fn(&PlanePolygon) -> PlanePolygon;

/// The library's step on a polygon that has a leg.
fn chaikin_step(polygon: &PlanePolygon) -> PlanePolygon {
    polygon.chaikin().expect("a leg")
}

#[test]
fn approximating_interpolating() {
    type Numbers = ControlPolygon<f64>;
    let law = |implementation: fn(&Numbers) -> Numbers, kind: SchemeKind| {
        let number = || prop_oneof![(-8..=8).prop_map(f64::from), -8.0..8.0];
        let vertices = prop::collection::vec(number(), 1..10);
        for_all((vertices, [number(), number()]), |(vertices, map)| {
            let polygon = ControlPolygon::closed(vertices.clone()).expect("finite vertices");
            laws::approximating_interpolating(implementation, kind, &polygon, *map)
        })
    };
    let inserting = SchemeKind::Interpolating { first: 0 };
    holds(law(|p| p.lane_riesenfeld(1).expect("closed"), inserting));
    holds(law(
        |p| p.chaikin().expect("closed"),
        SchemeKind::Approximating,
    ));
    holds(law(
        |p| p.cubic_step().expect("closed"),
        SchemeKind::Approximating,
    ));
    rejects(
        "it keeps nothing",
        law(|p| p.chaikin().expect("closed"), inserting),
    );
    rejects(
        "it keeps the vertices",
        law(
            |p| p.lane_riesenfeld(1).expect("closed"),
            SchemeKind::Approximating,
        ),
    );
    rejects(
        "weights with another sum",
        law(
            mutants::weights_do_not_sum_to_one,
            SchemeKind::Approximating,
        ),
    );
    rejects(
        "a vertex is moved",
        law(mutants::one_vertex_moved, inserting),
    );
}

#[test]
fn chaikin() {
    let law = |implementation: Step| {
        for_all(polygons(2, 1), |polygon| {
            laws::chaikin(implementation, polygon)
        })
    };
    holds(law(chaikin_step));
    rejects("cut at thirds", law(mutants::cut_at_thirds));
    rejects("cuts swapped", law(mutants::cuts_swapped));
    rejects("the ends are kept", law(mutants::ends_kept));
    rejects(
        "the last leg is forgotten",
        law(mutants::last_leg_forgotten),
    );
}

#[test]
fn chaikin_quarter_points() {
    let law = |implementation: Step| {
        for_all((polygons(2, 1), 1usize..=3), |(polygon, steps)| {
            laws::chaikin_quarter_points(implementation, polygon, *steps)
        })
    };
    holds(law(chaikin_step));
    rejects("cut at thirds", law(mutants::cut_at_thirds));
    rejects("cut at one end", law(mutants::cut_at_one_end));
    rejects("nothing is cut", law(mutants::nothing_cut));
}

#[test]
fn chaikin_convergence() {
    let law = |implementation: Step| {
        for_all((polygons(3, 1), 0usize..=3), |(polygon, steps)| {
            laws::chaikin_convergence(implementation, polygon, *steps)
        })
    };
    holds(law(chaikin_step));
    rejects("cut at thirds", law(mutants::cut_at_thirds));
    rejects("the ends are kept", law(mutants::ends_kept));
    rejects("cuts swapped", law(mutants::cuts_swapped));
}

#[test]
fn lane_riesenfeld() {
    let law = |implementation: fn(&PlanePolygon, usize) -> PlanePolygon| {
        for_all((polygons(3, 1), 0..=MAX_DEGREE), |(polygon, degree)| {
            laws::lane_riesenfeld(implementation, polygon, *degree)
        })
    };
    holds(law(|polygon, n| {
        polygon
            .lane_riesenfeld(n)
            .expect("three vertices are enough")
    }));
    rejects("averaged n + 1 times", law(mutants::averaged_once_more));
    rejects("averaged n − 1 times", law(mutants::averaged_once_less));
    rejects("doubled in every round", law(mutants::doubled_every_round));
    rejects("not doubled", law(mutants::not_doubled));
}
