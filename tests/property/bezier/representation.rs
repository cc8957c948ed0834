//! Properties of the Bernstein form.

use cagd::affine::Point;
use cagd::bezier::{BezierCurve, CasteljauTriangle, laws};

use crate::generators::{curves_and_parameters, for_all};
use crate::support::mutants::bezier::de_casteljau as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;
type Scheme = fn(&Curve, f64) -> CasteljauTriangle<Point<f64, 2>>;

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
