//! Limit stencils over rationals: all derivatives of splines up to degree 8, and the four-point scheme.

use cagd::bspline::uniform_b_spline;
use cagd::scalar::BigRational;
use cagd::subdivision::{LaurentPolynomial, LimitStencil, Mask, laws};

use crate::inputs::{for_each, integer, ratio};
use crate::support::mutants::subdivision::limit_points as mutants;
use crate::support::{holds, rejects};

type Q = BigRational;
type Stencil = fn(&Mask<Q>, usize) -> Option<LimitStencil<Q>>;

/// The r-th derivative of Nⁿ is the r-th backward difference of Nⁿ⁻ʳ.
fn derivative_of_b_spline(degree: usize, order: usize, u: i64) -> Q {
    if order == 0 {
        uniform_b_spline(degree, integer(u))
    } else {
        let lower = |u: i64| derivative_of_b_spline(degree - 1, order - 1, u);
        lower(u) - lower(u - 1)
    }
}

/// Scheme, order of the derivative, and what is known of the limit.
type Input = (Mask<Q>, usize, Vec<(i64, Q)>);

fn inputs() -> Vec<Input> {
    let splines = (2..=8_usize).flat_map(|degree| {
        // Of order n − 1 the derivative is continuous; of degree 1 there is no window but the point itself.
        (0..degree).map(move |order| {
            let known = (-(degree as i64) - 1..=0)
                .map(|j| (j, derivative_of_b_spline(degree, order, -j)))
                .collect();
            (Mask::lane_riesenfeld(degree), order, known)
        })
    });
    let tensions = [(1, 100), (1, 16), (1, 8), (17, 100), (9, 50)];
    let four_point = tensions.into_iter().flat_map(|(p, q)| {
        let w = ratio(p, q);
        let mask = Mask::four_point(w.clone()).expect("a finite tension");
        // (p₁ − p₋₁ − 2w(p₂ − p₋₂))/(2 − 8w)
        let scale = integer(2) - integer(8) * &w;
        let inner = integer(1) / &scale;
        let outer = integer(-2) * &w / &scale;
        let derivative = vec![
            (-2, -outer.clone()),
            (-1, -inner.clone()),
            (1, inner),
            (2, outer),
        ];
        [
            (mask.clone(), 0, vec![(0, integer(1))]),
            (mask, 1, derivative),
        ]
    });
    splines.chain(four_point).collect()
}

#[test]
fn limit_stencils() {
    let data = LaurentPolynomial::new(-4, [3, -1, 4, 1, -5, 9, 2].map(integer));
    let law = |implementation: Stencil| {
        for_each(inputs(), |(mask, order, known)| {
            let limit = |j: i64| {
                let entry = known.iter().find(|(index, _)| *index == j);
                entry.map_or_else(|| integer(0), |(_, value)| value.clone())
            };
            laws::limit_stencils(|mask| implementation(mask, *order), mask, limit, &data)
        })
    };
    holds(law(|mask, order| mask.limit_stencil(order).ok()));
    rejects("the next derivative", law(mutants::order_too_high));
    rejects("the window shifted", law(mutants::index_off_by_one));
    rejects("between two points", law(mutants::half_way));
    rejects("another scheme", law(mutants::scheme_of_differences));
}
