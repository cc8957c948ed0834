//! Subdivision, proved for every degree up to 12.

use cagd::bezier::{BezierCurve, bernstein, laws};
use cagd::scalar::BigRational;

use crate::inputs::{MAX_DEGREE, for_each, integer, ratio, unit_curves};
use crate::support::mutants::bezier::subdivision as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<BigRational>;

/// Both sides have degree n in α and degree n in t: a grid of (n + 1)² pairs proves the identity.
fn grid(degree: usize) -> impl Iterator<Item = (BigRational, BigRational)> {
    let numbers = move || (0..=degree as i64).map(move |k| integer(k - degree as i64 / 2));
    numbers().flat_map(move |alpha| numbers().map(move |t| (alpha.clone(), t)))
}

#[test]
fn bernstein_scaling() {
    let law = |implementation: fn(usize, i64, BigRational) -> BigRational| {
        let inputs = (0..=MAX_DEGREE).flat_map(|n| grid(n).map(move |(alpha, t)| (n, alpha, t)));
        for_each(inputs, |(n, alpha, t)| {
            laws::bernstein_scaling(implementation, *n, alpha.clone(), t.clone())
        })
    };
    holds(law(bernstein));
    rejects("no binomial coefficient", law(mutants::without_binomial));
    rejects("i and n − i swapped", law(mutants::index_reversed));
    rejects("not 0 beyond the degree", law(mutants::not_zero_beyond));
}

/// The lemma on scaled Bernstein polynomials and the intermediate points give all degrees; here the pieces
/// themselves are compared, on full grids up to degree 7 and for α = 1/2 up to degree 12.
#[test]
fn subdivision() {
    let law = |implementation: fn(&Curve, BigRational) -> [Curve; 2]| {
        let full = (0..=7).flat_map(|n| {
            unit_curves(n)
                .flat_map(move |curve| grid(n).map(move |(alpha, t)| (curve.clone(), alpha, t)))
        });
        let halves = (8..=MAX_DEGREE).flat_map(|n| {
            unit_curves(n).flat_map(move |curve| {
                (0..=n as i64).map(move |t| (curve.clone(), ratio(1, 2), integer(t)))
            })
        });
        for_each(full.chain(halves), |(curve, alpha, t)| {
            laws::subdivision(implementation, curve, alpha.clone(), t.clone())
        })
    };
    holds(law(mutants::subdivided));
    rejects("α and 1 − α swapped", law(mutants::parameter_reversed));
    rejects("right piece backwards", law(mutants::right_piece_reversed));
    rejects("as the notes print it", law(mutants::as_printed));
    rejects("straight pieces", law(mutants::straight_pieces));
}

/// Checked on unit curves and on zigzags, for which the bound of the legs is reached: (0, d, 0, d, …).
#[test]
fn corner_cutting_convergence() {
    let law = |implementation: fn(&Curve, usize) -> Vec<BigRational>| {
        let zigzags = (0..=MAX_DEGREE).map(|n| {
            let values = (0..=n as i64).map(|i| integer(i % 2));
            BezierCurve::new(values).expect("control values")
        });
        let lines = (1..=MAX_DEGREE)
            .map(|n| BezierCurve::new((0..=n as i64).map(integer)).expect("control values"));
        let curves = (0..=6).flat_map(unit_curves).chain(zigzags).chain(lines);
        let inputs = curves.flat_map(|curve| (0..=2).map(move |steps| (curve.clone(), steps)));
        for_each(inputs, |(curve, steps)| {
            laws::corner_cutting_convergence(implementation, curve, *steps)
        })
    };
    holds(law(mutants::corner_cutting));
    rejects("cut at a third", law(mutants::cut_at_a_third));
    rejects(
        "P₀ is the left half",
        law(mutants::starts_with_the_left_half),
    );
    rejects("joints stand twice", law(mutants::joints_twice));
    rejects("no corner is cut", law(mutants::midpoints_only));
}
