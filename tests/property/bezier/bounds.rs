//! Properties of the chord bound and the control polygon bound.

use cagd::affine::Point;
use cagd::bezier::bounds::{euclidean_norm, maximum_norm};
use cagd::bezier::{BezierCurve, laws};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{curve, for_all, inner_parameter};
use crate::support::mutants::bezier::{bounds as mutants, subdivision as cutting};
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;

/// Curves of degree at least `least`.
fn curve_of_degree(least: usize) -> impl Strategy<Value = Curve> {
    curve().prop_filter("a degree that is high enough", move |curve| {
        curve.degree() >= least
    })
}

/// Tolerances between a tenth and 10⁻⁹ of the size of the curve.
fn relative_tolerance() -> impl Strategy<Value = f64> {
    (1i32..=9, 1.0..10.0).prop_map(|(power, factor): (i32, f64)| factor * 10f64.powi(-power))
}

fn size(curve: &Curve) -> f64 {
    curve
        .control_points()
        .iter()
        .flat_map(|point| point.coordinates().to_vec())
        .fold(0.0, |largest: f64, x| largest.max(x.abs()))
}

#[test]
fn chord_bound() {
    let law = |implementation: fn(&Curve) -> f64| {
        for_all((curve(), inner_parameter()), |(curve, t)| {
            laws::chord_bound(implementation, curve, *t)
        })
    };
    holds(law(|curve| curve.chord_bound(maximum_norm)));
    rejects("n² for n(n − 1)", law(mutants::degree_squared));
    rejects("the factor is forgotten", law(mutants::factor_forgotten));
    rejects("distance to the set", law(mutants::distance_to_the_set));
    rejects("first differences", law(mutants::first_differences));
}

#[test]
fn chord_segment_bound() {
    let law = |implementation: fn(&Curve) -> f64| {
        for_all((curve(), inner_parameter()), |(curve, t)| {
            laws::chord_segment_bound(implementation, curve, *t)
        })
    };
    holds(law(mutants::worst_control_point));
    rejects("only the middle", law(mutants::middle_control_point));
    rejects("from the start", law(mutants::from_the_start));
}

/// The chord bound in the Euclidean norm is at most √2 times, and at least once, that in the maximum norm.
#[test]
fn norms_agree() {
    let law = |implementation: fn(&Curve) -> f64| {
        for_all(curve(), |curve| {
            let maximum = curve.chord_bound(maximum_norm);
            let euclidean = implementation(curve);
            let rounding = Rounding::new(8, 2.0 * maximum);
            Sides::new(curve)
                .at_most("|v|_∞ ≤ |v|₂", [maximum], [euclidean], rounding)
                .at_most(
                    "|v|₂² ≤ 2|v|_∞²",
                    [euclidean / maximum.max(f64::MIN_POSITIVE)],
                    [2f64.sqrt()],
                    Rounding::new(12, 2.0),
                )
        })
    };
    holds(law(|curve| curve.chord_bound(euclidean_norm)));
    rejects(
        "sum of the coordinates",
        law(|curve| curve.chord_bound(|v| v[0].abs() + v[1].abs())),
    );
    rejects(
        "first coordinate only",
        law(|curve| curve.chord_bound(|v| v[0].abs())),
    );
}

#[test]
fn control_polygon_bound() {
    let law = |implementation: fn(&Curve) -> f64| {
        let inputs = (curve_of_degree(1), 0usize..1000, inner_parameter());
        for_all(inputs, |(curve, leg, lambda)| {
            laws::control_polygon_bound(implementation, curve, leg % curve.degree(), *lambda)
        })
    };
    holds(law(|curve| curve.control_polygon_bound(maximum_norm)));
    rejects("w forgotten", law(mutants::parity_forgotten));
    rejects("⌊n/2⌋²", law(mutants::rounded_down_twice));
    rejects(
        "the chord's factor",
        law(|curve| curve.chord_bound(maximum_norm)),
    );
}

#[test]
fn subdivision_second_differences() {
    let law = |implementation: fn(&Curve) -> [Curve; 2]| {
        for_all(curve_of_degree(2), |curve| {
            laws::subdivision_second_differences(implementation, curve)
        })
    };
    holds(law(BezierCurve::halves));
    rejects(
        "split at a third",
        law(|curve| cutting::subdivided(curve, 1.0 / 3.0)),
    );
    rejects(
        "right piece backwards",
        law(|curve| cutting::right_piece_reversed(curve, 0.5)),
    );
    rejects(
        "straight pieces",
        law(|curve| cutting::straight_pieces(curve, 0.5)),
    );
}

#[test]
fn subdivision_depth() {
    let law = |implementation: fn(&Curve, &f64) -> usize| {
        let inputs = (
            curve(),
            relative_tolerance(),
            any::<usize>(),
            inner_parameter(),
        );
        for_all(inputs, |(curve, relative, seed, t)| {
            let tolerance = relative * size(curve).max(1e-150);
            laws::subdivision_depth(implementation, curve, tolerance, *seed, *t)
        })
    };
    holds(law(mutants::depth));
    rejects("halved a step", law(mutants::error_halved_a_step));
    rejects("rounded down", law(mutants::rounded_down));
    rejects("one more", law(mutants::one_more));
}

#[test]
fn uniform_convergence() {
    let law = |implementation: fn(&Curve, usize) -> Vec<Point<f64, 2>>| {
        let inputs = (
            curve_of_degree(1),
            0usize..=5,
            any::<usize>(),
            inner_parameter(),
        );
        for_all(inputs, |(curve, steps, seed, lambda)| {
            laws::uniform_convergence(implementation, curve, *steps, *seed, *lambda)
        })
    };
    holds(law(cutting::corner_cutting));
    rejects("cut at a third", law(cutting::cut_at_a_third));
    rejects(
        "P₀ is the left half",
        law(cutting::starts_with_the_left_half),
    );
    rejects("no corner is cut", law(cutting::midpoints_only));
}
