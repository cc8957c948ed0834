//! Properties of the Bernstein form.

use cagd::affine::Point;
use cagd::bezier::{BezierCurve, CasteljauTriangle, laws};

use proptest::prelude::*;

use crate::generators::{curves_and_parameters, for_all, for_all_of};
use crate::support::mutants::bezier::{de_casteljau as mutants, representation as wrong};
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;
type Scheme = fn(&Curve, f64) -> CasteljauTriangle<Point<f64, 2>>;
type Evaluate = fn(&Curve, f64) -> Point<f64, 2>;

#[test]
fn intermediate_points() {
    let law = |implementation: Scheme| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::intermediate_points(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::triangle));
    rejects("t and 1 − t swapped", law(mutants::parameter_reversed));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
    rejects("index off by one", law(mutants::index_off_by_one));
}

#[test]
fn bernstein_representation() {
    let law = |implementation: Evaluate| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::bernstein_representation(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::at));
    holds(law(BezierCurve::at_linear));
    rejects("t and 1 − t swapped", law(wrong::parameter_reversed));
    rejects("the domain is forgotten", law(wrong::domain_forgotten));
    rejects(
        "the binomial coefficients are forgotten",
        law(wrong::no_binomials),
    );
    rejects("the sum starts at b₁", law(wrong::index_off_by_one));
}

#[test]
fn linear_evaluation() {
    let law = |implementation: Evaluate| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::linear_evaluation(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::at_linear));
    rejects(
        "the binomial coefficients are forgotten",
        law(wrong::no_binomials),
    );
    rejects("t and 1 − t swapped", law(wrong::parameter_reversed));

    // Degrees about and beyond the one where Horner's scheme ends and C(n, i) overflows.
    let high_degrees = (
        prop_oneof![Just(499_usize), Just(500), Just(501), Just(800), Just(1500)],
        0.0..1.0,
        0..4,
    );
    let law = |implementation: fn(&BezierCurve<f64>, f64) -> f64| {
        for_all_of(12, high_degrees.clone(), |&(degree, t, shape)| {
            let values = (0..=degree as i32).map(|i| f64::from((i * i + shape) % 7 - 3) * 1e150);
            let curve = BezierCurve::new(values).expect("finite control values");
            laws::linear_evaluation(implementation, &curve, t)
        })
    };
    holds(law(BezierCurve::at_linear));
    rejects(
        "all in one power of 1 − t",
        law(wrong::powers_of_the_quotient),
    );
}
