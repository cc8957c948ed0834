//! The algorithm of de Casteljau, proved for every degree up to 12.

use cagd::affine::Point;
use cagd::bezier::{BezierCurve, CasteljauTriangle, laws};
use cagd::scalar::BigRational;

use crate::inputs::{MAX_DEGREE, for_each, unit_curves_and_parameters};
use crate::support::mutants::bezier::de_casteljau as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<BigRational>;
type Scheme = fn(&Curve, BigRational) -> CasteljauTriangle<BigRational>;

#[test]
fn de_casteljau() {
    let law = |implementation: Scheme| {
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::de_casteljau(implementation, curve, u.clone())
        })
    };
    holds(law(BezierCurve::triangle));
    rejects("t and 1 − t swapped", law(mutants::parameter_reversed));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
    rejects("index off by one", law(mutants::index_off_by_one));
}

#[test]
fn de_casteljau_examples() {
    type PlaneScheme = fn(
        &BezierCurve<Point<BigRational, 2>>,
        BigRational,
    ) -> CasteljauTriangle<Point<BigRational, 2>>;
    let law = |implementation: PlaneScheme| {
        for_each([()], |()| laws::de_casteljau_examples(implementation))
    };
    holds(law(BezierCurve::triangle));
    rejects("t and 1 − t swapped", law(mutants::parameter_reversed));
    rejects("always the middle", law(mutants::always_midpoints));
    rejects("index off by one", law(mutants::index_off_by_one));
}
