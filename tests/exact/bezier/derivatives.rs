//! Derivatives and integrals, proved for every degree up to 12; end curvature checked on whole grids.

use std::num::NonZeroUsize;

use cagd::affine::{Interval, Point};
use cagd::bezier::{
    BezierCurve, CasteljauTriangle, ParabolaMap, QuadraticTrace, bernstein_derivative as library,
    bernstein_higher_derivative as library_higher, laws,
};
use cagd::curves::curvature::{plane_curvature_squared, space_curvature_squared};
use cagd::law::{Rounding, Sides};
use cagd::scalar::BigRational;
use num_traits::Zero;

use crate::inputs::{
    MAX_DEGREE, at, for_each, integer, interval, ratio, unit_curves_and_parameters, unit_curves_on,
};
use crate::support::mutants::bezier::derivatives as mutants;
use crate::support::{holds, rejects};

type Q = BigRational;
type Curve = BezierCurve<Q>;
type PlaneCurve = BezierCurve<Point<Q, 2>>;

/// The derivative of a polynomial of degree n has degree n − 1: n parameters prove it.
#[test]
fn bernstein_derivative() {
    let inputs: Vec<(usize, i64, Q)> = (0..=MAX_DEGREE)
        .flat_map(|n| (-1..=n as i64 + 1).map(move |i| (n, i)))
        .flat_map(|(n, i)| (0..n.max(1) as i64).map(move |k| (n, i, integer(k - 3))))
        .collect();
    let law = |implementation: fn(usize, i64, Q) -> Q| {
        for_each(inputs.clone(), |(n, i, t)| {
            laws::bernstein_derivative(implementation, *n, *i, t.clone())
        })
    };
    holds(law(library));
    rejects("neighbours exchanged", law(mutants::neighbours_exchanged));
    rejects("degree n instead of n − 1", law(mutants::degree_kept));
    rejects("no left neighbour", law(mutants::one_neighbour));
}

/// All orders, with the m − p + 1 parameters that a polynomial of degree m − p needs.
#[test]
fn bernstein_higher_derivative() {
    type Implementation = fn(&Interval<Q>, usize, i64, usize, Q) -> Q;
    let domains = [
        (Interval::unit(), MAX_DEGREE),
        (interval(2, 5), MAX_DEGREE / 2),
    ];
    let mut inputs = Vec::new();
    for (domain, max_degree) in domains {
        for m in 0..=max_degree {
            for (i, p) in (-1..=m as i64 + 1).flat_map(|i| (0..=m + 1).map(move |p| (i, p))) {
                for k in 0..=m.saturating_sub(p) as i64 {
                    inputs.push((domain.clone(), m, i, p, domain.start() + integer(k)));
                }
            }
        }
    }
    let law = |implementation: Implementation| {
        for_each(inputs.clone(), |(domain, m, i, p, u)| {
            laws::bernstein_higher_derivative(implementation, domain, *m, *i, *p, u.clone())
        })
    };
    holds(law(library_higher));
    rejects(
        "m − j instead of m − p, as printed",
        law(mutants::printed_degree),
    );
    rejects("no chain rule", law(mutants::basis_chain_rule_forgotten));
    rejects("no signs", law(mutants::signs_forgotten));
}

#[test]
fn derivative() {
    let law = |implementation: fn(&Curve, Q) -> Q| {
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::derivative(implementation, curve, u.clone())
        })
    };
    holds(law(|curve, u| curve.derivative().at(u)));
    rejects(
        "no factor n",
        law(|curve, u| mutants::factor_forgotten(curve).at(u)),
    );
    rejects(
        "no chain rule",
        law(|curve, u| mutants::chain_rule_forgotten(curve).at(u)),
    );
    rejects(
        "differences reversed",
        law(|curve, u| mutants::reversed_legs(curve).at(u)),
    );
}

/// Curves of degree at least `least`.
fn curves_from(least: usize) -> impl Iterator<Item = (Curve, Q)> {
    unit_curves_and_parameters(MAX_DEGREE).filter(move |(curve, _)| curve.degree() >= least)
}

#[test]
fn derivative_consequences() {
    let law = |implementation: fn(&Curve) -> Curve| {
        for_each(curves_from(1), |(curve, u)| {
            laws::derivative_consequences(implementation, curve, u.clone())
        })
    };
    holds(law(BezierCurve::derivative));
    rejects("no factor n, as printed", law(mutants::factor_forgotten));
    rejects("no chain rule", law(mutants::chain_rule_forgotten));
    rejects("differences reversed", law(mutants::reversed_legs));
}

#[test]
fn second_derivative() {
    let law = |implementation: fn(&Curve, Q) -> Q| {
        for_each(curves_from(2), |(curve, u)| {
            laws::second_derivative(implementation, curve, u.clone())
        })
    };
    holds(law(|curve, u| curve.second_derivative().at(u)));
    holds(law(|curve, u| {
        let [_, second] = curve.derivatives(u);
        second
    }));
    rejects("n² instead of n(n − 1)", law(mutants::square_of_the_degree));
    rejects(
        "the middle point counted once",
        law(mutants::middle_counted_once),
    );
}

/// Unit curves with every order up to n + 1, and as many parameters as the derivative needs.
fn curves_and_orders() -> impl Iterator<Item = (Curve, NonZeroUsize, Q)> {
    let domains = [
        (Interval::unit(), MAX_DEGREE),
        (interval(2, 5), MAX_DEGREE / 2),
    ];
    domains.into_iter().flat_map(|(domain, max_degree)| {
        (0..=max_degree).flat_map(move |n| {
            let start = domain.start();
            unit_curves_on(domain.clone(), n).flat_map(move |curve| {
                let start = start.clone();
                (1..=n + 1).flat_map(move |p| {
                    let (curve, start) = (curve.clone(), start.clone());
                    let order = NonZeroUsize::new(p).expect("p ≥ 1");
                    (0..=n.saturating_sub(p) as i64)
                        .map(move |k| (curve.clone(), order, start.clone() + integer(k)))
                })
            })
        })
    })
}

#[test]
fn higher_derivative() {
    let law = |implementation: fn(&Curve, NonZeroUsize) -> Curve| {
        for_each(curves_and_orders(), |(curve, order, u)| {
            laws::higher_derivative(implementation, curve, *order, u.clone())
        })
    };
    holds(law(BezierCurve::higher_derivative));
    rejects("n⋯(n − p), as printed", law(mutants::one_factor_too_many));
    rejects("nᵖ", law(mutants::power_of_the_degree));
    rejects(
        "b − a instead of (b − a)ᵖ",
        law(mutants::one_interval_length),
    );
}

/// One entry of `BezierCurve::derivatives`, by its order up to 14.
fn from_triangle(curve: &Curve, u: Q, order: NonZeroUsize) -> Q {
    let derivatives: [Q; 14] = curve.derivatives(u);
    derivatives[order.get() - 1].clone()
}

/// `derivatives` computes all orders at once: degrees up to 8 keep this fast.
#[test]
fn derivatives_from_triangle() {
    let law = |implementation: fn(&Curve, Q, NonZeroUsize) -> Q| {
        let inputs = curves_and_orders().filter(|(curve, ..)| curve.degree() <= 8);
        for_each(inputs, |(curve, order, u)| {
            laws::derivatives_from_triangle(implementation, curve, u.clone(), *order)
        })
    };
    holds(law(from_triangle));
    rejects("column p", law(mutants::wrong_column));
    rejects(
        "t and 1 − t swapped",
        law(mutants::triangle_from_the_other_end),
    );
}

#[test]
fn de_casteljau_worked_example() {
    type Scheme = fn(&PlaneCurve, Q) -> CasteljauTriangle<Point<Q, 2>>;
    let law = |implementation: Scheme| {
        for_each([()], |()| laws::de_casteljau_worked_example(implementation))
    };
    holds(law(BezierCurve::triangle));
    rejects("control points reversed", law(mutants::reversed_triangle));
    let right: PlaneCurve = BezierCurve::new(
        [[0, 0], [4, 9], [17, 13], [22, 4]].map(|p| Point::new(p.map(|x| ratio(x, 2)))),
    )
    .expect("four points");
    let printed = Point::new([ratio(663, 100), ratio(454, 100)]);
    assert_ne!(
        right.at(ratio(3, 5)),
        printed,
        "6.63 is not even rounded right"
    );
}

/// Polygons in the plane with first and last legs on a small grid, zero legs among them.
fn plane_polygons() -> Vec<PlaneCurve> {
    let mut polygons = Vec::new();
    for n in 2..=MAX_DEGREE as i64 {
        for (x, y) in (-1..=1).flat_map(|x| (-1..=1).map(move |y| (x, y))) {
            let points = (0..=n).map(|i| match i {
                0 => at(&[0, 0]),
                1 => at(&[x, y]),
                2 => at(&[x + 2, y - 1]),
                _ if i == n => at(&[5 * i, x]),
                _ => at(&[5 * i, i * i * (y + 2)]),
            });
            polygons.push(BezierCurve::on(interval(0, 3), points).expect("points"));
        }
    }
    polygons
}

/// Checked, not proved: for every degree up to 12 on a grid of legs, singular ends included.
#[test]
fn end_curvature() {
    let law = |implementation: fn(&PlaneCurve, Q) -> Option<Q>| {
        for_each(plane_polygons(), |curve| {
            laws::end_curvature(implementation, curve)
        })
    };
    holds(law(|curve, u| {
        let [first, second] = curve.derivatives(u);
        plane_curvature_squared(&first, &second)
    }));
    rejects(
        "no factor (n − 1)/n",
        law(mutants::curvature_factor_forgotten),
    );
    rejects(
        "sign at the end",
        law(mutants::curvature_of_the_reversed_curve),
    );
    rejects(
        "0 at singular ends",
        law(mutants::singular_taken_for_straight),
    );
}

#[test]
fn end_curvature_in_space() {
    type SpaceCurve = BezierCurve<Point<Q, 3>>;
    let curves: Vec<SpaceCurve> = plane_polygons()
        .into_iter()
        .map(|curve| {
            let points = curve.control_points().iter().enumerate().map(|(i, p)| {
                let height = integer((i as i64 - 1) * (i as i64 - 1));
                Point::new([p[0].clone(), p[1].clone(), height])
            });
            BezierCurve::on(interval(0, 3), points).expect("points")
        })
        .collect();
    let law = |implementation: fn(&SpaceCurve, Q) -> Option<Q>| {
        for_each(curves.clone(), |curve| {
            laws::end_curvature_in_space(implementation, curve)
        })
    };
    holds(law(|curve, u| {
        let [first, second] = curve.derivatives(u);
        space_curvature_squared(&first, &second)
    }));
    rejects(
        "κ² without the factor",
        law(|curve, u| {
            let [first, second] = curve.higher_derivative(NonZeroUsize::MIN).derivatives(u);
            space_curvature_squared(&first, &second)
        }),
    );
}

/// Both sides are linear in the control points and of degree 2 in t: three parameters prove it.
#[test]
fn quadratic_parabola() {
    type Map = fn(&Curve, Q, Q) -> Q;
    let inputs: Vec<(Curve, Q)> = [Interval::unit(), interval(2, 5)]
        .into_iter()
        .flat_map(|domain| unit_curves_on(domain, 2))
        .flat_map(|curve| (-1..=1).map(move |k| (curve.clone(), integer(k))))
        .collect();
    let law = |implementation: Map| {
        for_each(inputs.clone(), |(curve, u)| {
            laws::quadratic_parabola(implementation, curve, u.clone())
        })
    };
    holds(law(|curve, x, y| {
        ParabolaMap::of(curve)
            .expect("three control points")
            .apply(x, y)
    }));
    rejects(
        "b₁ − b₀ instead of 2(b₁ − b₀)",
        law(mutants::tangent_not_doubled),
    );
    rejects("b₂ − b₀ for the axis", law(mutants::chord_for_axis));
}

/// The trace of a quadratic curve on a line is told exactly: b′ = 0 inside, or nowhere inside.
#[test]
fn quadratic_trace_on_a_line() {
    for (b1, b2) in (-3..=3).flat_map(|b1| (-3..=3).map(move |b2| (b1, b2))) {
        let curve: PlaneCurve =
            BezierCurve::new([at(&[0, 0]), at(&[b1, 2 * b1]), at(&[b2, 2 * b2])]).expect("points");
        let hodograph = curve.derivative();
        // b′ is linear: it vanishes inside if and only if its end values have opposite signs.
        let (start, end) = (b1, b2 - b1);
        match curve.quadratic_trace().expect("three control points") {
            QuadraticTrace::Turning { at } => {
                assert!(start * end < 0, "0, {b1}, {b2}");
                assert!(hodograph.at(at).iter().all(Q::is_zero));
            }
            QuadraticTrace::Segment => assert!(start * end >= 0 && (start, end) != (0, 0)),
            QuadraticTrace::Point => assert_eq!((start, end), (0, 0)),
            QuadraticTrace::Parabola => panic!("0, {b1}, {b2} are collinear"),
        }
    }
    let bent: PlaneCurve =
        BezierCurve::new([at(&[0, 0]), at(&[1, 2]), at(&[2, 0])]).expect("points");
    assert_eq!(bent.quadratic_trace(), Ok(QuadraticTrace::Parabola));
}

#[test]
fn integral() {
    let inputs: Vec<Curve> = [Interval::unit(), interval(2, 5)]
        .into_iter()
        .flat_map(|domain| (0..=MAX_DEGREE).flat_map(move |m| unit_curves_on(domain.clone(), m)))
        .collect();
    let law = |implementation: fn(&Curve) -> Q| {
        for_each(inputs.clone(), |curve| {
            laws::integral(implementation, curve)
        })
    };
    holds(law(BezierCurve::integral));
    holds(law(|curve| {
        let primitive = curve.antiderivative(integer(7));
        primitive.at(curve.domain().end()) - primitive.at(curve.domain().start())
    }));
    rejects(
        "1/m instead of 1/(m + 1)",
        law(mutants::divided_by_the_degree),
    );
    rejects(
        "no interval length",
        law(mutants::interval_length_forgotten),
    );
    rejects("ends count half", law(mutants::ends_count_half));
    holds(for_each(inputs.clone(), |curve| {
        laws::antiderivative(
            |hodograph: &Curve, start| hodograph.antiderivative(start),
            curve,
        )
    }));
    rejects(
        "no share of the interval",
        for_each(inputs.clone(), |curve| {
            laws::antiderivative(mutants::antiderivative_without_share, curve)
        }),
    );
    // The mean is the integral over the length.
    holds(for_each(inputs.clone(), |curve| {
        let scaled = curve.mean() * curve.domain().length();
        Sides::new(curve).equal("mean", [scaled], [curve.integral()], Rounding::none())
    }));
}
