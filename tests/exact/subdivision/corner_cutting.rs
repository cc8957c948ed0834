//! Corner cutting, proved for polygons up to a number of vertices.

use cagd::scalar::BigRational;
use cagd::subdivision::laws;

use super::polygons::{MAX_DEGREE, Polygon, unit_polygons};
use crate::inputs::for_each;
use crate::support::mutants::subdivision::corner_cutting as mutants;
use crate::support::{holds, rejects};

type Step = fn(&Polygon) -> Polygon;

/// The library's step on a polygon that has a leg.
fn step(polygon: &Polygon) -> Polygon {
    polygon.chaikin().expect("a leg")
}

#[test]
fn chaikin() {
    let law = |implementation: Step| {
        for_each(unit_polygons(2, 6), |polygon| {
            laws::chaikin(implementation, polygon)
        })
    };
    holds(law(step));
    rejects("cut at thirds", law(mutants::cut_at_thirds));
    rejects("cuts swapped", law(mutants::cuts_swapped));
    rejects("the ends are kept", law(mutants::ends_kept));
    rejects(
        "the last leg is forgotten",
        law(mutants::last_leg_forgotten),
    );
}

/// Each of the polygons, for 1 to 3 steps.
fn polygons_and_steps(least: usize) -> impl Iterator<Item = (Polygon, usize)> {
    unit_polygons(least, 6).flat_map(|polygon| (1..=3).map(move |steps| (polygon.clone(), steps)))
}

#[test]
fn chaikin_quarter_points() {
    let law = |implementation: Step| {
        for_each(polygons_and_steps(2), |(polygon, steps)| {
            laws::chaikin_quarter_points(implementation, polygon, *steps)
        })
    };
    holds(law(step));
    rejects("cut at thirds", law(mutants::cut_at_thirds));
    rejects("cut at one end", law(mutants::cut_at_one_end));
    rejects("nothing is cut", law(mutants::nothing_cut));
}

#[test]
fn chaikin_convergence() {
    let law = |implementation: Step| {
        for_each(polygons_and_steps(3), |(polygon, steps)| {
            laws::chaikin_convergence(implementation, polygon, *steps)
        })
    };
    holds(law(step));
    rejects("cut at thirds", law(mutants::cut_at_thirds));
    rejects("the ends are kept", law(mutants::ends_kept));
    rejects("cuts swapped", law(mutants::cuts_swapped));
}

#[test]
fn lane_riesenfeld() {
    type Averaging = fn(&Polygon, usize) -> Polygon;
    let law = |implementation: Averaging| {
        let input = (0..=MAX_DEGREE).flat_map(|degree| {
            unit_polygons(degree / 2 + 1, degree + 3).map(move |polygon| (polygon, degree))
        });
        for_each(input, |(polygon, degree): &(Polygon, usize)| {
            laws::lane_riesenfeld::<BigRational>(implementation, polygon, *degree)
        })
    };
    holds(law(|polygon, n| {
        polygon.lane_riesenfeld(n).expect("enough vertices")
    }));
    rejects("averaged n + 1 times", law(mutants::averaged_once_more));
    rejects("averaged n − 1 times", law(mutants::averaged_once_less));
    rejects("doubled in every round", law(mutants::doubled_every_round));
    rejects("not doubled", law(mutants::not_doubled));
}
