//! The Bernstein form, proved for every degree up to 12.

use cagd::bezier::{BezierCurve, CasteljauTriangle, laws};
use cagd::scalar::BigRational;

use crate::inputs::{MAX_DEGREE, for_each, unit_curves_and_parameters};
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
