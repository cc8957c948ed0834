//! Worked numbers of derivatives.

use super::Computed;
use crate::affine::Point;
use crate::bezier::{BezierCurve, QuadraticTrace};
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("worked_example", worked_example),
    ("turning_point", turning_point),
];

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

/// The triangle of (0, 0), (2, 9/2), (17/2, 13/2), (11, 2) at 3/5, and the first two derivatives from it.
fn worked_example() -> String {
    let points = [[0, 0], [4, 9], [17, 13], [22, 4]];
    let points = points.map(|point| Point::new(point.map(|x| ratio(x, 2))));
    let curve = BezierCurve::new(points).expect("four points");
    let t = ratio(3, 5);
    let triangle = curve.triangle(t.clone());
    let decimal = |x: &BigRational| tex::decimal(x, 3);
    let mut table = String::from("| $b_i$ | $b_i^1$ | $b_i^2$ | $b_i^3$ |\n|---|---|---|---|\n");
    for row in 0..=curve.degree() {
        // Row i of the scheme holds the points whose last control point is bᵢ.
        let cells: Vec<String> = (0..=curve.degree())
            .map(|level| match row.checked_sub(level) {
                Some(i) => format!("${}$", tex::point(triangle.point(level, i), decimal)),
                None => String::new(),
            })
            .collect();
        table += &format!("| {} |\n", cells.join(" | "));
    }
    let [first, second] = curve.derivatives(t);
    let [last, column] = [2, 1].map(|level| {
        triangle
            .column(level)
            .iter()
            .map(|point| tex::point(point, decimal))
            .collect::<Vec<_>>()
    });
    let (first, second) = (tex::point(&first, decimal), tex::point(&second, decimal));
    let tip = tex::point(triangle.tip(), decimal);
    format!(
        "{table}\nSo $b(0.6) = {tip}$.\n\
         The derivatives are\n\n\
         $b'(0.6) = 3 \\left( {} - {} \\right) = {first}$ and\n\n\
         $b''(0.6) = 6 \\left( {} - 2 \\cdot {} + {} \\right) = {second}$.\n",
        last[1], last[0], column[2], column[1], column[0]
    )
}

/// Where the curve of the values 0, 2, 1 turns back.
fn turning_point() -> String {
    let values = [0, 2, 1].map(|x| Point::new([ratio(x, 1)]));
    let curve = BezierCurve::new(values).expect("three points");
    match curve.quadratic_trace() {
        Ok(QuadraticTrace::Turning { at }) => {
            let [top, end] = [at.clone(), ratio(1, 1)].map(|t| tex::fraction(&curve.at(t)[0]));
            format!(
                "The point moves up to ${top}$, which it reaches at $t = {}$, and comes back to ${end}$.",
                tex::fraction(&at)
            )
        }
        other => unreachable!("0, 2, 1 turn back, but the trace is {other:?}"),
    }
}
