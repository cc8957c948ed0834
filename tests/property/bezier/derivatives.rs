//! Properties of derivatives, end curvature, parabolas and integrals.

use std::num::NonZeroUsize;

use cagd::affine::{Interval, Point, Vector};
use cagd::bezier::{
    BezierCurve, CasteljauTriangle, ParabolaMap, bernstein, bernstein_derivative as library,
    bernstein_higher_derivative as library_higher, laws,
};
use cagd::curves::curvature::{plane_curvature_squared, space_curvature_squared};
use cagd::scalar::Dual64;
use proptest::prelude::*;

use crate::generators::{
    MAX_DEGREE, curve, curves_and_parameters, domain, for_all, local_parameter,
};
use crate::support::mutants::bezier::derivatives as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;
type Hodograph = BezierCurve<Vector<f64, 2>>;

/// A degree, an index from −1 to n + 1, and a parameter.
fn polynomials() -> impl Strategy<Value = (usize, i64, f64)> {
    (0..=MAX_DEGREE, local_parameter())
        .prop_flat_map(|(n, t)| (Just(n), -1..=n as i64 + 1, Just(t)))
}

#[test]
fn bernstein_derivative() {
    let law = |implementation: fn(usize, i64, f64) -> f64| {
        for_all(polynomials(), |(n, i, t)| {
            laws::bernstein_derivative(implementation, *n, *i, *t)
        })
    };
    holds(law(library));
    // Dual numbers differentiate the program that computes Bᵢⁿ.
    holds(law(|n, i, t| bernstein(n, i, Dual64::new(t, 1.0)).eps));
    rejects("neighbours exchanged", law(mutants::neighbours_exchanged));
    rejects("degree n instead of n − 1", law(mutants::degree_kept));
    rejects("no left neighbour", law(mutants::one_neighbour));
}

#[test]
fn bernstein_higher_derivative() {
    type Implementation = fn(&Interval<f64>, usize, i64, usize, f64) -> f64;
    let inputs = || (domain(), polynomials(), 0..=MAX_DEGREE + 1);
    let law = |implementation: Implementation| {
        for_all(inputs(), |(domain, (m, i, t), p)| {
            laws::bernstein_higher_derivative(implementation, domain, *m, *i, *p, domain.global(*t))
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
    let law = |implementation: fn(&Curve, f64) -> Vector<f64, 2>| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::derivative(implementation, curve, *u)
        })
    };
    holds(law(|curve, u| curve.derivative().at(u)));
    holds(law(|curve, u| {
        let [first] = curve.derivatives(u);
        first
    }));
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

/// Curves of degree at least `least`, with a parameter.
fn curves_from(least: usize) -> impl Strategy<Value = (Curve, f64)> {
    curves_and_parameters().prop_filter("the degree is too small", move |(curve, _)| {
        curve.degree() >= least
    })
}

#[test]
fn derivative_consequences() {
    let law = |implementation: fn(&Curve) -> Hodograph| {
        for_all(curves_from(1), |(curve, u)| {
            laws::derivative_consequences(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::derivative));
    rejects("no factor n, as printed", law(mutants::factor_forgotten));
    rejects("no chain rule", law(mutants::chain_rule_forgotten));
    rejects("differences reversed", law(mutants::reversed_legs));
}

#[test]
fn second_derivative() {
    let law = |implementation: fn(&Curve, f64) -> Vector<f64, 2>| {
        for_all(curves_from(2), |(curve, u)| {
            laws::second_derivative(implementation, curve, *u)
        })
    };
    holds(law(|curve, u| curve.second_derivative().at(u)));
    rejects("n² instead of n(n − 1)", law(mutants::square_of_the_degree));
    rejects(
        "the middle point counted once",
        law(mutants::middle_counted_once),
    );
}

/// Orders from 1 to one more than the highest degree.
fn order() -> impl Strategy<Value = NonZeroUsize> {
    (1..=MAX_DEGREE + 1).prop_map(|p| NonZeroUsize::new(p).expect("p ≥ 1"))
}

#[test]
fn higher_derivative() {
    let law = |implementation: fn(&Curve, NonZeroUsize) -> Hodograph| {
        for_all((curves_and_parameters(), order()), |((curve, u), order)| {
            laws::higher_derivative(implementation, curve, *order, *u)
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

#[test]
fn derivatives_from_triangle() {
    type Implementation = fn(&Curve, f64, NonZeroUsize) -> Vector<f64, 2>;
    let law = |implementation: Implementation| {
        for_all((curves_and_parameters(), order()), |((curve, u), order)| {
            laws::derivatives_from_triangle(implementation, curve, *u, *order)
        })
    };
    holds(law(|curve, u, order| {
        let derivatives: [Vector<f64, 2>; MAX_DEGREE + 1] = curve.derivatives(u);
        derivatives[order.get() - 1]
    }));
    rejects("column p", law(mutants::wrong_column));
    rejects(
        "t and 1 − t swapped",
        law(mutants::triangle_from_the_other_end),
    );
}

#[test]
fn de_casteljau_worked_example() {
    type Scheme = fn(&Curve, f64) -> CasteljauTriangle<Point<f64, 2>>;
    let law = |implementation: Scheme| {
        for_all(Just(()), |()| {
            laws::de_casteljau_worked_example(implementation)
        })
    };
    holds(law(BezierCurve::triangle));
    rejects("control points reversed", law(mutants::reversed_triangle));
}

/// Curves of degree at least 2 and of moderate size: squares of curvatures of tiny curves are out of range.
/// What scaling does to the curvature is the matter of `tests/property/curves`.
fn moderate_curves() -> impl Strategy<Value = Curve> {
    curve().prop_filter("another size or degree", |curve| {
        let far = |point: &Point<f64, 2>| {
            let size = point[0].abs().max(point[1].abs());
            size != 0.0 && !(1e-10..1e10).contains(&size)
        };
        curve.degree() >= 2 && !curve.control_points().iter().any(far)
    })
}

#[test]
fn end_curvature() {
    let law = |implementation: fn(&Curve, f64) -> Option<f64>| {
        for_all(moderate_curves(), |curve| {
            laws::end_curvature(implementation, curve)
        })
    };
    holds(law(|curve, u| {
        let [first, second] = curve.derivatives(u);
        plane_curvature_squared(&first, &second)
    }));
    holds(law(|curve, u| {
        let curvature = cagd::curves::PlaneCurvature::curvature(curve, u).ok()?;
        Some(curvature * curvature.abs())
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
    type SpaceCurve = BezierCurve<Point<f64, 3>>;
    let lifted = || {
        moderate_curves().prop_map(|curve| {
            let points = curve.control_points().iter().enumerate();
            let points = points.map(|(i, p)| Point::new([p[0], p[1], (i as f64 - 1.0).powi(2)]));
            SpaceCurve::on(*curve.domain(), points).expect("finite points")
        })
    };
    let law = |implementation: fn(&SpaceCurve, f64) -> Option<f64>| {
        for_all(lifted(), |curve| {
            laws::end_curvature_in_space(implementation, curve)
        })
    };
    holds(law(|curve, u| {
        let [first, second] = curve.derivatives(u);
        space_curvature_squared(&first, &second)
    }));
    holds(law(|curve, u| {
        let curvature = cagd::curves::SpaceCurvature::curvature(curve, u).ok()?;
        Some(curvature * curvature)
    }));
    rejects(
        "κ instead of κ²",
        law(|curve, u| cagd::curves::SpaceCurvature::curvature(curve, u).ok()),
    );
}

#[test]
fn quadratic_parabola() {
    type Map = fn(&Curve, f64, f64) -> Point<f64, 2>;
    let quadratic = || {
        curves_from(2).prop_map(|(curve, u)| {
            let points = curve.control_points()[..3].to_vec();
            (
                Curve::on(*curve.domain(), points).expect("finite points"),
                u,
            )
        })
    };
    let law = |implementation: Map| {
        for_all(quadratic(), |(curve, u)| {
            laws::quadratic_parabola(implementation, curve, *u)
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

#[test]
fn integral() {
    let of_vectors = || {
        curve().prop_map(|curve| {
            let vectors = curve.control_points().iter().map(Point::from_origin);
            Hodograph::on(*curve.domain(), vectors).expect("finite vectors")
        })
    };
    let law = |implementation: fn(&Hodograph) -> Vector<f64, 2>| {
        for_all(of_vectors(), |curve| laws::integral(implementation, curve))
    };
    holds(law(BezierCurve::integral));
    holds(law(|curve| curve.mean() * curve.domain().length()));
    rejects(
        "1/m instead of 1/(m + 1)",
        law(mutants::divided_by_the_degree),
    );
    rejects(
        "no interval length",
        law(mutants::interval_length_forgotten),
    );
    rejects("ends count half", law(mutants::ends_count_half));
    let law = |implementation: fn(&Hodograph, Point<f64, 2>) -> Curve| {
        for_all(curve(), |curve| laws::antiderivative(implementation, curve))
    };
    holds(law(|hodograph, start| hodograph.antiderivative(start)));
    rejects(
        "no share of the interval",
        law(mutants::antiderivative_without_share),
    );
}
