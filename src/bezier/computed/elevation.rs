//! Worked numbers of degree elevation and Bernstein approximation.

use super::Computed;
use crate::affine::Point;
use crate::bezier::BezierCurve;
use crate::book::tex;
use crate::scalar::{BigRational, OrderedScalar, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("elevated_parabola", elevated_parabola),
    ("corner_approximation", corner_approximation),
    ("far_control_points", far_control_points),
];

fn rational(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

/// The parabola of (0,0), (2,4), (4,0), elevated twice.
fn elevated_parabola() -> String {
    let points = [[0, 0], [2, 4], [4, 0]].map(|p| Point::new(p.map(rational)));
    let mut curve = BezierCurve::new(points).expect("three points");
    let mut table = String::from("| degree | control points |\n|---|---|\n");
    for _ in 0..3 {
        let points: Vec<String> = curve
            .control_points()
            .iter()
            .map(|point| format!("${}$", tex::point(point, tex::fraction)))
            .collect();
        table += &format!("| {} | {} |\n", curve.degree(), points.join(", "));
        curve = curve.elevated();
    }
    table
}

/// How far B_m(F; 1/2) is from F(1/2) = 0 for F(t) = |t − 1/2|, beside the bound 1/(2√m).
fn corner_approximation() -> String {
    let half = BigRational::from_ratio(1, 2);
    let mut table = String::from(
        "| $m$ | $B_m(F;\\tfrac12)$ | bound $\\frac{1}{2\\sqrt m}$ |\n|---|---|---|\n",
    );
    for m in [2, 8, 32] {
        let corner = |t: BigRational| OrderedScalar::abs(&(t - half.clone()));
        let approximation = BezierCurve::bernstein_approximation(corner, m).expect("finite values");
        let value = approximation.at(half.clone());
        let bound = 0.5 / libm::sqrt(m as f64);
        table += &format!("| {m} | {} | {bound:.4} |\n", tex::decimal(&value, 4));
    }
    table
}

/// The greatest height of the curve of degree 9 whose middle control points have height 10.
fn far_control_points() -> String {
    let heights = [0, 0, 0, 0, 10, 10, 0, 0, 0, 0].map(rational);
    let curve = BezierCurve::new(heights).expect("ten heights");
    // By symmetry the curve is highest in the middle: both middle Bernstein polynomials together
    // are symmetric about 1/2 and increase up to there.
    tex::decimal(&curve.at(BigRational::from_ratio(1, 2)), 2)
}
