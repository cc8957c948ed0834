//! Properties of the algorithm of de Casteljau.

use cagd::affine::Point;
use cagd::bezier::{BezierCurve, CasteljauTriangle, Counted, laws, recursive_at};

use crate::generators::{curves_and_parameters, for_all};
use crate::support::mutants::bezier::de_casteljau as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;
type Scheme = fn(&Curve, f64) -> CasteljauTriangle<Point<f64, 2>>;

#[test]
fn de_casteljau() {
    let law = |implementation: Scheme| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::de_casteljau(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::triangle));
    rejects("t and 1 − t swapped", law(mutants::parameter_reversed));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
    rejects("index off by one", law(mutants::index_off_by_one));
}

#[test]
fn de_casteljau_cost() {
    type Counting = fn(&BezierCurve<Counted<Point<f64, 2>>>, f64) -> Counted<Point<f64, 2>>;
    type Recursive = fn(&Curve, f64) -> (Point<f64, 2>, u64);
    let law = |implementation: Counting, recursive: Recursive| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::de_casteljau_cost(implementation, recursive, curve, *u)
        })
    };
    let at: Counting = BezierCurve::at;
    holds(law(at, recursive_at));
    rejects(
        "recursion",
        law(mutants::recursion_as_written, recursive_at),
    );
    rejects("all columns", law(mutants::all_columns_kept, recursive_at));
    rejects("every point once", law(at, mutants::every_point_once));
    rejects("first call", law(at, mutants::first_call_forgotten));
}
