//! The Bernstein form, proved for every degree up to 12.

use cagd::affine::Interval;
use cagd::bezier::{
    BezierCurve, CasteljauTriangle, MonomialCurve, TrianglePath, TrianglePaths, bernstein_matrix,
    laws, monomial_matrix,
};
use cagd::scalar::BigRational;
use nalgebra::DMatrix;

use crate::inputs::{MAX_DEGREE, for_each, integer, interval, unit_curves_and_parameters};
use crate::support::mutants::bezier::{de_casteljau as mutants, representation as wrong};
use crate::support::{holds, rejects};

type Curve = BezierCurve<BigRational>;
type Scheme = fn(&Curve, BigRational) -> CasteljauTriangle<BigRational>;
type Evaluate = fn(&Curve, BigRational) -> BigRational;

#[test]
fn intermediate_points() {
    let law = |implementation: Scheme| {
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::intermediate_points(implementation, curve, u.clone())
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
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::bernstein_representation(implementation, curve, u.clone())
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

/// Every degree with the n + 1 parameters 0 … n.
fn degrees_and_parameters() -> impl Iterator<Item = (usize, BigRational)> {
    (0..=MAX_DEGREE).flat_map(|n| (0..=n as i64).map(move |t| (n, integer(t))))
}

#[test]
fn basis_function_from_de_casteljau() {
    let law = |implementation: Scheme| {
        let inputs =
            degrees_and_parameters().flat_map(|(n, t)| (0..=n).map(move |k| (n, k, t.clone())));
        for_each(inputs, |(n, k, t)| {
            laws::basis_function_from_de_casteljau(implementation, *n, *k, t.clone())
        })
    };
    holds(law(BezierCurve::triangle));
    rejects("t and 1 − t swapped", law(mutants::parameter_reversed));
    rejects("index off by one", law(mutants::index_off_by_one));
    rejects("midpoints for every t", law(wrong::midpoints));
}

fn paths(n: usize, k: usize) -> Vec<TrianglePath> {
    TrianglePaths::new(n, k).collect()
}

/// Proved for every degree up to 8: one parameter more than the degree; degree 12 has 4096 paths.
#[test]
fn de_casteljau_path_counting() {
    let law = |implementation: fn(usize, usize) -> Vec<TrianglePath>| {
        let inputs = (0..=8_usize).flat_map(|n| {
            (0..=n).flat_map(move |k| (0..=n as i64).map(move |t| (n, k, integer(t))))
        });
        let high = (9..=MAX_DEGREE).flat_map(|n| (0..=n).map(move |k| (n, k, integer(2))));
        for_each(inputs.chain(high), |(n, k, t)| {
            laws::de_casteljau_path_counting(implementation, *n, *k, t.clone())
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
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::de_casteljau_derivation(implementation, curve, u.clone())
        })
    };
    holds(law(BezierCurve::triangle));
    rejects("t and 1 − t swapped", law(mutants::parameter_reversed));
    rejects("midpoints for every t", law(wrong::midpoints));
    rejects("index off by one", law(mutants::index_off_by_one));
}

fn value(coefficients: &[BigRational], t: BigRational) -> BigRational {
    let form = MonomialCurve::new(coefficients[0].clone(), coefficients[1..].to_vec());
    form.expect("finite coefficients").at(t)
}

#[test]
fn polynomial_space() {
    let law = |implementation: fn(&[BigRational], BigRational) -> BigRational| {
        // The law is linear in the coefficients, so each power alone proves it.
        let inputs = (0..=MAX_DEGREE).flat_map(|n| {
            (0..=n).map(move |k| -> Vec<BigRational> {
                (0..=n).map(|j| integer(i64::from(j == k))).collect()
            })
        });
        for_each(inputs, |coefficients| {
            laws::polynomial_space(implementation, coefficients)
        })
    };
    holds(law(value));
    rejects("the powers start at 1", law(wrong::powers_shifted));
    rejects(
        "the highest power is missing",
        law(wrong::highest_power_missing),
    );
}

fn both_changes(n: usize) -> (DMatrix<BigRational>, DMatrix<BigRational>) {
    (bernstein_matrix(n), monomial_matrix(n))
}

#[test]
fn bernstein_basis() {
    type Changes = fn(usize) -> (DMatrix<BigRational>, DMatrix<BigRational>);
    let law = |implementation: Changes| {
        for_each(degrees_and_parameters(), |(n, t)| {
            laws::bernstein_basis(implementation, *n, t.clone())
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

fn to_bezier(form: &MonomialCurve<BigRational>, interval: Interval<BigRational>) -> Curve {
    let form = form.over(interval).expect("exact coefficients");
    BezierCurve::from_monomial(&form).expect("exact coefficients")
}

#[test]
fn every_polynomial_curve() {
    type ToBezier = fn(&MonomialCurve<BigRational>, Interval<BigRational>) -> Curve;
    let law = |implementation: ToBezier| {
        // Whole numbers up to the highest degree; intervals that bring fractions show the maps of the
        // parameters, for which a few degrees are enough.
        let whole = (interval(0, 1), interval(1, 2), MAX_DEGREE);
        let fractions = (interval(1, 3), interval(2, 7), 5);
        let inputs = [whole, fractions]
            .into_iter()
            .flat_map(|(from, to, highest)| {
                (0..=highest).flat_map(move |n| {
                    let (from, to) = (from.clone(), to.clone());
                    (0..=n).flat_map(move |k| {
                        let coefficient = move |j: usize| integer(i64::from(j == k));
                        let vectors = (1..=n).map(coefficient);
                        let form = MonomialCurve::on(from.clone(), coefficient(0), vectors);
                        let form = form.expect("finite coefficients");
                        let to = to.clone();
                        (0..=n as i64).map(move |u| (form.clone(), to.clone(), integer(u)))
                    })
                })
            });
        for_each(inputs, |(form, interval, u)| {
            laws::every_polynomial_curve(implementation, form, interval.clone(), u.clone())
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
fn cubic_matrix_form() {
    let law = |implementation: fn(usize) -> DMatrix<BigRational>| {
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::cubic_matrix_form(implementation, curve, u.clone())
        })
    };
    holds(law(bernstein_matrix));
    rejects("signs forgotten", law(wrong::signs_forgotten));
    rejects("rows in rising order", law(wrong::rows_reversed));
}

#[test]
fn monomial_form() {
    let law = |implementation: fn(&Curve) -> MonomialCurve<BigRational>| {
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::monomial_form(implementation, curve, u.clone())
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
