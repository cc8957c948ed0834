//! The bounds, checked exactly, with the control values bₖ = k² for which they are reached.

use cagd::affine::{Affine, Point};
use cagd::bezier::bounds::maximum_norm;
use cagd::bezier::{BezierCurve, laws};
use cagd::scalar::BigRational;

use crate::inputs::{MAX_DEGREE, for_each, integer, ratio, unit_curves};
use crate::support::mutants::bezier::{bounds as mutants, subdivision as cutting};
use crate::support::{holds, rejects};

type Curve = BezierCurve<BigRational>;

/// The control values bₖ = k², all of whose second differences are 2.
fn squares(degree: usize) -> Curve {
    BezierCurve::new((0..=degree as i64).map(|k| integer(k * k))).expect("control values")
}

/// Squares, single ones and irregular values.
fn curves(least: usize) -> impl Iterator<Item = Curve> {
    let irregular = (least..=MAX_DEGREE).map(|n| {
        let values = (0..=n as i64).map(|k| integer((7 * k * k + 3 * k + 2) % 11 - 5));
        BezierCurve::new(values).expect("control values")
    });
    (least..=MAX_DEGREE)
        .map(squares)
        .chain((least..=6).flat_map(unit_curves))
        .chain(irregular)
}

/// The ends, the middle and four places between.
fn parameters() -> impl Iterator<Item = BigRational> {
    [(0, 1), (1, 5), (1, 3), (1, 2), (3, 4), (1, 1)]
        .into_iter()
        .map(|(p, q)| ratio(p, q))
}

#[test]
fn chord_bound() {
    let law = |implementation: fn(&Curve) -> BigRational| {
        let inputs = curves(0).flat_map(|curve| parameters().map(move |t| (curve.clone(), t)));
        for_each(inputs, |(curve, t)| {
            laws::chord_bound(implementation, curve, t.clone())
        })
    };
    holds(law(|curve| curve.chord_bound(maximum_norm)));
    rejects("n² for n(n − 1)", law(mutants::degree_squared));
    rejects("the factor is forgotten", law(mutants::factor_forgotten));
    rejects("distance to the set", law(mutants::distance_to_the_set));
    rejects("first differences", law(mutants::first_differences));
    for n in 0..=MAX_DEGREE {
        let curve = squares(n);
        let points = curve.control_points();
        let chord = points[0].lerp(&points[n], ratio(1, 2));
        assert_eq!(
            chord - curve.at(ratio(1, 2)),
            curve.chord_bound(maximum_norm),
            "the bound is reached at t = 1/2 for bₖ = k², n = {n}"
        );
    }
}

#[test]
fn chord_segment_bound() {
    type PlaneCurve = BezierCurve<Point<BigRational, 2>>;
    let law = |implementation: fn(&PlaneCurve) -> BigRational| {
        let curves = (0..=8).map(|n: i64| {
            let points = (0..=n).map(|k| {
                Point::new([
                    integer((5 * k * k + k) % 7),
                    integer((3 * k * k * k + 2 * k) % 5),
                ])
            });
            BezierCurve::new(points).expect("control points")
        });
        let inputs = curves.flat_map(|curve| parameters().map(move |t| (curve.clone(), t)));
        for_each(inputs, |(curve, t)| {
            laws::chord_segment_bound(implementation, curve, t.clone())
        })
    };
    holds(law(mutants::worst_control_point));
    rejects("only the middle", law(mutants::middle_control_point));
    rejects("from the start", law(mutants::from_the_start));
}

#[test]
fn control_polygon_bound() {
    let law = |implementation: fn(&Curve) -> BigRational| {
        let inputs = curves(1).flat_map(|curve| {
            (0..curve.degree()).flat_map(move |leg| {
                let curve = curve.clone();
                [(0, 1), (2, 5)].map(move |(p, q)| (curve.clone(), leg, ratio(p, q)))
            })
        });
        for_each(inputs, |(curve, leg, lambda)| {
            laws::control_polygon_bound(implementation, curve, *leg, lambda.clone())
        })
    };
    holds(law(|curve| curve.control_polygon_bound(maximum_norm)));
    rejects("w forgotten", law(mutants::parity_forgotten));
    rejects("⌊n/2⌋²", law(mutants::rounded_down_twice));
    rejects(
        "the chord's factor",
        law(|curve| curve.chord_bound(maximum_norm)),
    );
    for n in 1..=MAX_DEGREE {
        let curve = squares(n);
        let middle = n / 2;
        let at_vertex = curve.at(ratio(middle as i64, n as i64));
        assert_eq!(
            at_vertex - curve.control_points()[middle].clone(),
            curve.control_polygon_bound(maximum_norm),
            "the bound is reached at t = ⌊n/2⌋/n for bₖ = k², n = {n}"
        );
    }
}

/// An identity that is linear in the control points: unit curves prove it for their degree.
#[test]
fn subdivision_second_differences() {
    let law = |implementation: fn(&Curve) -> [Curve; 2]| {
        let inputs = (2..=MAX_DEGREE).flat_map(unit_curves).chain(curves(2));
        for_each(inputs, |curve| {
            laws::subdivision_second_differences(implementation, curve)
        })
    };
    holds(law(BezierCurve::halves));
    rejects(
        "split at a third",
        law(|curve| cutting::subdivided(curve, ratio(1, 3))),
    );
    rejects(
        "right piece backwards",
        law(|curve| cutting::right_piece_reversed(curve, ratio(1, 2))),
    );
    rejects(
        "straight pieces",
        law(|curve| cutting::straight_pieces(curve, ratio(1, 2))),
    );
}

#[test]
fn subdivision_depth() {
    let law = |implementation: fn(&Curve, &BigRational) -> usize| {
        let tolerances = [ratio(1, 1), ratio(1, 4), ratio(1, 100), ratio(3, 1000)];
        let inputs = curves(0).flat_map(|curve| {
            tolerances
                .clone()
                .map(move |tolerance| (curve.clone(), tolerance))
        });
        for_each(inputs, |(curve, tolerance)| {
            laws::subdivision_depth(implementation, curve, tolerance.clone(), 1, ratio(1, 2))
        })
    };
    holds(law(mutants::depth));
    rejects("halved a step", law(mutants::error_halved_a_step));
    rejects("rounded down", law(mutants::rounded_down));
    rejects("one more", law(mutants::one_more));
}
