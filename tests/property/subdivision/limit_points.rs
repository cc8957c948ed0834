//! Properties of limit stencils.

use cagd::bspline::uniform_b_spline;
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::{LimitStencil, Mask, laws};

use super::masks::data;
use crate::generators::for_all_of;
use crate::support::mutants::subdivision::limit_points as mutants;
use crate::support::{holds, rejects};

type Q = BigRational;

/// The limit of a single point is the B-spline Nⁿ, and Nⁿ(−j) the value that the point j gives at 0.
#[test]
fn limit_stencils() {
    type Stencil = fn(&Mask<Q>, usize) -> Option<LimitStencil<Q>>;
    let law = |implementation: Stencil| {
        for_all_of(64, (2_usize..=7, data()), |(degree, data)| {
            let mask = Mask::lane_riesenfeld(*degree);
            let limit = |j: i64| uniform_b_spline(*degree, <Q as Scalar>::from_integer(-j));
            laws::limit_stencils(|mask| implementation(mask, 0), &mask, limit, data)
        })
    };
    holds(law(|mask, order| mask.limit_stencil(order).ok()));
    rejects("the next derivative", law(mutants::order_too_high));
    rejects("the window shifted", law(mutants::index_off_by_one));
    rejects("between two points", law(mutants::half_way));
    rejects("another scheme", law(mutants::scheme_of_differences));
}
