//! Worked numbers of uniform splines.

use super::Computed;
use crate::book::tex;
use crate::bspline::{UniformSpline, uniform_b_spline};
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("b_spline_values", b_spline_values),
    ("b_spline_pieces", b_spline_pieces),
];

/// The values of the uniform B-splines at the whole numbers.
fn b_spline_values() -> String {
    let mut table = String::from(
        "| $n$ | $N^n(1)$ | $N^n(2)$ | $N^n(3)$ | $N^n(4)$ | $N^n(5)$ |\n|--:|---|---|---|---|---|\n",
    );
    for degree in 1..=5_usize {
        let cells = (1..=5).map(|u| {
            if u > degree {
                return String::new();
            }
            let value = uniform_b_spline(degree, <BigRational as Scalar>::from_integer(u as i64));
            format!("${}$", tex::fraction(&value))
        });
        table += &format!("| {degree} | {} |\n", cells.collect::<Vec<_>>().join(" | "));
    }
    table
}

/// The Bézier points of the pieces of the quadratic and the cubic B-spline.
fn b_spline_pieces() -> String {
    let mut table = String::from("| B-spline | piece | Bézier points |\n|---|---|---|\n");
    for degree in [2, 3] {
        let values =
            (0..=2 * degree).map(|i| <BigRational as Scalar>::from_integer(i64::from(i == degree)));
        let spline = UniformSpline::new(degree, values).expect("2n + 1 control values");
        for piece in 0..spline.segment_count() {
            let segment = spline.segment(piece).expect("one of its segments");
            let points: Vec<String> = segment
                .control_points()
                .iter()
                .map(|point| format!("${}$", tex::fraction(point)))
                .collect();
            table += &format!(
                "| $N^{degree}$ | $[{piece}, {}]$ | {} |\n",
                piece + 1,
                points.join(", ")
            );
        }
    }
    table
}
