//! Properties of degree elevation, reduction and Bernstein approximation.

use cagd::affine::{Affine, Point};
use cagd::bezier::{BezierCurve, laws};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{curve, curves_and_parameters, for_all, inner_parameter, polygon};
use crate::support::mutants::bezier::elevation as mutants;
use crate::support::{holds, rejects};

type Point2 = Point<f64, 2>;
type Curve = BezierCurve<Point2>;

#[test]
fn degree_elevation() {
    let law = |implementation: fn(&Curve) -> Curve| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::degree_elevation(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::elevated));
    rejects("n for n + 1", law(mutants::degree_for_degree_plus_one));
    rejects("weights swapped", law(mutants::weights_swapped));
    rejects("midpoints", law(mutants::midpoints));
    rejects("last point repeated", law(mutants::last_point_repeated));
}

#[test]
fn bernstein_approximation() {
    let law = |implementation: fn(&dyn Fn(f64) -> Point2, usize) -> Curve| {
        let polygons = polygon().prop_filter("m ≥ 1", |points| points.len() > 1);
        for_all((polygons, inner_parameter()), |(points, t)| {
            laws::bernstein_approximation(implementation, points, *t)
        })
    };
    holds(law(|function, degree| {
        BezierCurve::bernstein_approximation(function, degree).expect("finite values")
    }));
    rejects("sampled in the middle", law(mutants::sampled_in_the_middle));
    rejects("sampled backwards", law(mutants::sampled_backwards));
}

/// What was elevated can be reduced, and comes back.
///
/// Solving the recurrence multiplies the rounding of an elevated point, 4 roundings, by at most
/// n + 2 as derived at `reduced`; solving adds 5 roundings a step.
#[test]
fn reduction_undoes_elevation() {
    let law = |elevate: fn(&Curve) -> Curve| {
        for_all(curve(), |curve| {
            let largest = curve
                .control_points()
                .iter()
                .flat_map(|point| Affine::coordinates(point).to_vec())
                .fold(0.0, |a: f64, x| a.max(x.abs()));
            let n = curve.degree() as f64;
            let back = elevate(curve).reduced();
            let found: Vec<f64> = back.iter().flat_map(coordinates).collect();
            Sides::new(curve).equal(
                "the control points come back",
                found,
                coordinates(curve),
                Rounding::new(5 * curve.degree() + 9, 2.0 * (n + 2.0) * largest),
            )
        })
    };
    holds(law(BezierCurve::elevated));
    rejects("midpoints", law(mutants::midpoints));
}

fn coordinates(curve: &Curve) -> Vec<f64> {
    let points = curve.control_points();
    points
        .iter()
        .flat_map(|point| Affine::coordinates(point).to_vec())
        .collect()
}
