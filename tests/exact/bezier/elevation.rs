//! Degree elevation and Bernstein approximation, proved for every degree up to 12.

use cagd::bezier::{BezierCurve, laws};
use cagd::scalar::BigRational;

use crate::inputs::{MAX_DEGREE, for_each, integer, interval, unit_curves, unit_curves_on};
use crate::support::mutants::bezier::elevation as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<BigRational>;

/// Both sides have degree at most n + 1 in t, so n + 2 parameters prove them equal.
fn curves_and_parameters() -> impl Iterator<Item = (Curve, BigRational)> {
    (0..=MAX_DEGREE)
        .flat_map(unit_curves)
        .chain((0..=3).flat_map(|degree| unit_curves_on(interval(2, 5), degree)))
        .flat_map(|curve| {
            let start = curve.domain().start();
            (0..=curve.degree() as i64 + 1)
                .map(move |k| (curve.clone(), start.clone() + integer(k)))
        })
}

#[test]
fn degree_elevation() {
    let law = |implementation: fn(&Curve) -> Curve| {
        for_each(curves_and_parameters(), |(curve, u)| {
            laws::degree_elevation(implementation, curve, u.clone())
        })
    };
    holds(law(BezierCurve::elevated));
    rejects("weights swapped", law(mutants::weights_swapped));
    rejects("midpoints", law(mutants::midpoints));
    rejects("last point repeated", law(mutants::last_point_repeated));
}

#[test]
fn reduction_undoes_elevation() {
    for degree in 0..=MAX_DEGREE {
        for curve in unit_curves(degree) {
            assert_eq!(curve.elevated().reduced(), Ok(curve.clone()), "{curve}");
            assert!(
                degree == 0 || curve.reduced().is_err(),
                "Δⁿb₀ ≠ 0 for a unit curve: {curve}"
            );
        }
    }
}
