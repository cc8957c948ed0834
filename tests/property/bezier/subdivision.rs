//! Properties of subdivision and corner cutting.

use cagd::affine::{Affine, Interval, Point};
use cagd::bezier::{BezierCurve, bernstein, laws};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{MAX_DEGREE, curve, for_all, inner_parameter, local_parameter};
use crate::support::mutants::bezier::subdivision as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;

#[test]
fn bernstein_scaling() {
    let law = |implementation: fn(usize, i64, f64) -> f64| {
        let inputs = (0..=MAX_DEGREE, local_parameter(), local_parameter());
        for_all(inputs, |(degree, alpha, t)| {
            laws::bernstein_scaling(implementation, *degree, *alpha, *t)
        })
    };
    holds(law(bernstein));
    rejects("no binomial coefficient", law(mutants::without_binomial));
    rejects("i and n − i swapped", law(mutants::index_reversed));
    rejects("not 0 beyond the degree", law(mutants::not_zero_beyond));
}

#[test]
fn subdivision() {
    let law = |implementation: fn(&Curve, f64) -> [Curve; 2]| {
        let inputs = (curve(), local_parameter(), local_parameter());
        for_all(inputs, |(curve, alpha, t)| {
            laws::subdivision(implementation, curve, *alpha, *t)
        })
    };
    holds(law(mutants::subdivided));
    rejects("α and 1 − α swapped", law(mutants::parameter_reversed));
    rejects("right piece backwards", law(mutants::right_piece_reversed));
    rejects("as the notes print it", law(mutants::as_printed));
    rejects("straight pieces", law(mutants::straight_pieces));
}

#[test]
fn corner_cutting_convergence() {
    let law = |implementation: fn(&Curve, usize) -> Vec<Point<f64, 2>>| {
        for_all((curve(), 0usize..=4), |(curve, steps)| {
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

/// The piece over any interval is the curve itself.
///
/// A control point of a piece passes 3n roundings, its value 3n more, the value of the curve 3n.
/// The local parameters of both ends and of u, twice, have a relative error of 3u each;
/// they move the value by at most n·2·max|bᵢ| times that.
/// In pieces that are no shorter than 10⁻⁶ the rounding of u itself leads outside by less than 10⁻⁵.
#[test]
fn pieces_are_the_curve() {
    type Piece = fn(&Curve, Interval<f64>) -> Curve;
    let law = |implementation: Piece| {
        let inputs = (
            curve(),
            inner_parameter(),
            inner_parameter(),
            inner_parameter(),
        );
        let inputs = inputs.prop_filter("an interval", |(_, from, to, _)| (from - to).abs() > 1e-6);
        for_all(inputs, |(curve, from, to, t)| {
            let domain = curve.domain();
            let piece = Interval::new(domain.global(*from), domain.global(*to));
            let piece = piece.expect("two different ends");
            let n = curve.degree();
            let size = curve
                .control_points()
                .iter()
                .flat_map(|point| Affine::coordinates(point).to_vec())
                .fold(0.0, |largest: f64, x| largest.max(x.abs()));
            let u = piece.global(*t);
            let rounding = Rounding::new(33 * n + 1, 1.001 * size);
            Sides::new(format!("u = {u}, {curve}")).equal(
                "a piece is the curve",
                Affine::coordinates(&implementation(curve, piece).at(u)).to_vec(),
                Affine::coordinates(&curve.at(u)).to_vec(),
                rounding,
            )
        })
    };
    holds(law(|curve, piece| {
        curve.restricted(piece).expect("inside the domain")
    }));
    rejects(
        "only the domain is changed",
        law(|curve, piece| curve.reparametrised(piece)),
    );
    rejects(
        "the left part only",
        law(|curve, piece| {
            let left = Interval::new(curve.domain().start(), piece.end());
            match left {
                Ok(left) => curve
                    .restricted(left)
                    .expect("finite")
                    .reparametrised(piece),
                Err(_) => curve.reparametrised(piece),
            }
        }),
    );
}
