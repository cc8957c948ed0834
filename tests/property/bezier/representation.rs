//! Properties of the Bernstein form.

use cagd::affine::Point;
use cagd::affine::{Interval, Vector};
use cagd::bezier::{
    BezierCurve, CasteljauTriangle, MonomialCurve, TrianglePath, TrianglePaths, bernstein_matrix,
    laws, monomial_matrix,
};
use nalgebra::DMatrix;

use proptest::prelude::*;

use crate::generators::{
    curves_and_parameters, domain, for_all, for_all_of, local_parameter, polygon,
};
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

fn paths(n: usize, k: usize) -> Vec<TrianglePath> {
    TrianglePaths::new(n, k).collect()
}

#[test]
fn de_casteljau_path_counting() {
    let law = |implementation: fn(usize, usize) -> Vec<TrianglePath>| {
        let inputs = (0_usize..=9).prop_flat_map(|n| (Just(n), 0..=n, local_parameter()));
        for_all(inputs, |&(n, k, t)| {
            laws::de_casteljau_path_counting(implementation, n, k, t)
        })
    };
    holds(law(paths));
    rejects("a path is forgotten", law(wrong::path_missing));
    rejects("one path many times", law(wrong::one_path_repeated));
    rejects("t and 1 − t swapped", law(wrong::steps_swapped));
}

#[test]
fn de_casteljau_derivation() {
    let law = |implementation: Scheme| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::de_casteljau_derivation(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::triangle));
    rejects("t and 1 − t swapped", law(mutants::parameter_reversed));
    rejects("midpoints for every t", law(wrong::midpoints));
    rejects("index off by one", law(mutants::index_off_by_one));
}

fn both_changes(n: usize) -> (DMatrix<f64>, DMatrix<f64>) {
    (bernstein_matrix(n), monomial_matrix(n))
}

#[test]
fn bernstein_basis() {
    let law = |implementation: fn(usize) -> (DMatrix<f64>, DMatrix<f64>)| {
        for_all((0_usize..=12, local_parameter()), |&(n, t)| {
            laws::bernstein_basis(implementation, n, t)
        })
    };
    holds(law(both_changes));
    rejects(
        "signs forgotten",
        law(|n| (wrong::signs_forgotten(n), monomial_matrix(n))),
    );
    rejects("the way back not divided", law(wrong::way_back_not_divided));
    rejects("the way back in rising order", law(wrong::way_back_rising));
}

type ToBezier = fn(&MonomialCurve<Point<f64, 2>>, Interval<f64>) -> Curve;

fn to_bezier(form: &MonomialCurve<Point<f64, 2>>, interval: Interval<f64>) -> Curve {
    let form = form.over(interval).expect("the coefficients are in range");
    BezierCurve::from_monomial(&form).expect("the coefficients are in range")
}

/// A polynomial curve over one interval, another interval, and a local parameter of it.
fn polynomials() -> impl Strategy<Value = (MonomialCurve<Point<f64, 2>>, Interval<f64>, f64)> {
    (polygon(), domain(), domain(), local_parameter()).prop_map(|(points, first, second, t)| {
        let vectors = points[1..].iter().map(|p| p.from_origin());
        let vectors: Vec<Vector<f64, 2>> = vectors.collect();
        let form = MonomialCurve::on(first, points[0], vectors).expect("finite coefficients");
        (form, second, t)
    })
}

#[test]
fn every_polynomial_curve() {
    let law = |implementation: ToBezier| {
        for_all(polynomials(), |(form, interval, t)| {
            laws::every_polynomial_curve(implementation, form, *interval, interval.global(*t))
        })
    };
    holds(law(to_bezier));
    rejects(
        "the coefficients are not re-expanded",
        law(wrong::not_re_expanded),
    );
    rejects("partial sums of the coefficients", law(wrong::partial_sums));
    rejects(
        "the highest power is lost",
        law(wrong::last_coefficient_dropped),
    );
}

#[test]
fn monomial_form() {
    let law = |implementation: fn(&Curve) -> MonomialCurve<Point<f64, 2>>| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::monomial_form(implementation, curve, *u)
        })
    };
    holds(law(|curve| {
        curve.to_monomial().expect("the coefficients are in range")
    }));
    rejects(
        "without the factor C(n, k)",
        law(wrong::differences_without_factor),
    );
    rejects("the domain is forgotten", law(wrong::form_on_unit_interval));
}
