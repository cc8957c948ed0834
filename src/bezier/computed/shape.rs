//! Worked numbers of the shape of Bézier curves.

use super::Computed;
use crate::affine::{AffineMap, ConvexHull, Line, Point};
use crate::bezier::BezierCurve;
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("affine_image", affine_image),
    ("hull_cost", hull_cost),
    ("cubic_and_line", cubic_and_line),
];

fn rational(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

fn curve<const N: usize>(points: [[i64; 2]; N]) -> BezierCurve<Point<BigRational, 2>> {
    let points = points.map(|p| Point::new(p.map(rational)));
    BezierCurve::new(points).expect("a control polygon")
}

/// The control points of a cubic and its point at 1/4, and what a shear makes of them.
fn affine_image() -> String {
    let cubic = curve([[0, 0], [1, 2], [3, 2], [4, 0]]);
    let half = BigRational::from_ratio(1, 2);
    let rows = [[rational(1), half], [rational(0), rational(1)]];
    let shear = AffineMap::new(rows, [rational(2), rational(-1)]);
    let image = cubic.mapped(&shear).expect("exact numbers are finite");
    let quarter = BigRational::from_ratio(1, 4);
    let names = (0..=3)
        .map(|i| format!("b_{i}"))
        .chain(["b(\\tfrac14)".into()]);
    let tip = |curve: &BezierCurve<_>| [curve.at(quarter.clone())];
    let points = cubic.control_points().iter().cloned().chain(tip(&cubic));
    let images = image.control_points().iter().cloned().chain(tip(&image));
    let mut table = String::from("| | of the curve | of its image |\n|---|---|---|\n");
    for ((name, point), image) in names.zip(points).zip(images) {
        table += &format!(
            "| ${name}$ | ${}$ | ${}$ |\n",
            tex::point(&point, tex::fraction),
            tex::point(&image, tex::fraction)
        );
    }
    table
}

/// Comparisons and turns for hulls of more and more scattered points.
fn hull_cost() -> String {
    let mut table = String::from(
        "| points $m$ | comparisons | $m \\log_2 m$ | turns | $4m$ |\n|---|---|---|---|---|\n",
    );
    for power in [4_u32, 7, 10, 13] {
        let count = 1_i32 << power;
        // Multiples of large odd numbers modulo a power of two are well scattered.
        let scattered = |i: i32, factor: i32| f64::from(i.wrapping_mul(factor).rem_euclid(1 << 20));
        let points: Vec<_> = (0..count)
            .map(|i| Point::new([scattered(i, 648_391), scattered(i, 26_544_357)]))
            .collect();
        let cost = ConvexHull::of(&points).expect("finite points").cost();
        table += &format!(
            "| {count} | {} | {} | {} | {} |\n",
            cost.comparisons,
            count.unsigned_abs() * power,
            cost.turns,
            4 * count
        );
    }
    table
}

/// The line function of a cubic along a line that it meets three times.
fn cubic_and_line() -> String {
    let cubic = curve([[0, -3], [1, 9], [2, -9], [3, 3]]);
    let axis = Line::new([0, 1].map(rational), rational(0)).expect("a line");
    let function = cubic
        .hyperplane_function(&axis)
        .expect("exact numbers are finite");
    let values: Vec<String> = function
        .control_points()
        .iter()
        .map(tex::fraction)
        .collect();
    let meetings = cubic
        .line_intersections(&axis)
        .expect("exact numbers are finite");
    let parameters: Vec<String> = meetings
        .parameters()
        .iter()
        .map(|root| format!("${}$", tex::decimal(&root.parameter(), 4)))
        .collect();
    let points: Vec<String> = cubic
        .control_points()
        .iter()
        .map(|point| format!("${}$", tex::point(point, tex::fraction)))
        .collect();
    format!(
        "The control points are {}, and the line is the first axis.\n\
         The values of its function at the control points are ${}$.\n\
         Its zeros are, to four digits, {}.",
        points.join(", "),
        values.join(", "),
        parameters.join(", ")
    )
}
