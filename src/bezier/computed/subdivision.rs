//! Worked numbers of subdivision and corner cutting.

use super::Computed;
use crate::affine::Point;
use crate::bezier::BezierCurve;
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};

pub(super) const ALL: &[Computed] = &[
    ("subdivision_scheme", subdivision_scheme),
    ("corner_cutting_lengths", corner_cutting_lengths),
];

/// The scheme of the cubic (0,0), (0,9), (9,9), (9,0) at 1/3, one column a level.
fn subdivision_scheme() -> String {
    let points = [[0, 0], [0, 9], [9, 9], [9, 0]]
        .map(|p| Point::new(p.map(<BigRational as Scalar>::from_integer)));
    let curve = BezierCurve::new(points).expect("four points");
    let triangle = curve.triangle(BigRational::from_ratio(1, 3));
    let mut table = String::from("| level 0 | level 1 | level 2 | level 3 |\n|---|---|---|---|\n");
    for i in 0..=3 {
        let row: Vec<String> = (0..=3 - i)
            .map(|level| format!("${}$", tex::point(triangle.point(level, i), tex::fraction)))
            .chain(std::iter::repeat_n(String::new(), i))
            .collect();
        table += &format!("| {} |\n", row.join(" | "));
    }
    let side = |points: Vec<&Point<BigRational, 2>>| {
        let points: Vec<String> = points
            .into_iter()
            .map(|point| format!("${}$", tex::point(point, tex::fraction)))
            .collect();
        points.join(", ")
    };
    table
        + &format!(
            "\nThe first row gives the left piece: {}.\nThe last entry of each row, from below, gives the right piece backwards: {}.\n",
            side(triangle.left_side().collect()),
            side(
                triangle
                    .right_side()
                    .collect::<Vec<_>>()
                    .into_iter()
                    .rev()
                    .collect()
            ),
        )
}

/// Legs and distances of the first polygons of corner cutting, beside the bounds.
fn corner_cutting_lengths() -> String {
    let points = [[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new);
    let curve = BezierCurve::new(points).expect("four points");
    let longest_leg = 4.0;
    let mut table = String::from(
        "| $k$ | longest leg | $d/2^k$ | farthest vertex | $d/2^k$ times $\\lfloor n/2 \\rfloor$ |\n|---|---|---|---|---|\n",
    );
    // Dense enough for the four digits shown: neighbours are less than 0.003 apart, and near a nearest point
    // the distance grows with the square of the shift.
    let samples: Vec<Point<f64, 2>> = (0..=4096)
        .map(|k| curve.at(f64::from(k) / 4096.0))
        .collect();
    for polygon in curve.corner_cutting().take(5) {
        let bound = longest_leg / 2f64.powi(polygon.step() as i32);
        let leg = polygon
            .vertices()
            .windows(2)
            .map(|leg| (leg[1] - leg[0]).norm())
            .fold(0.0, f64::max);
        let away = polygon.vertices().iter().map(|vertex| {
            let distances = samples.iter().map(|point| (*point - *vertex).norm());
            distances.fold(f64::INFINITY, f64::min)
        });
        let farthest = away.fold(0.0, f64::max);
        table += &format!(
            "| {} | {leg:.4} | {bound:.4} | {farthest:.4} | {:.4} |\n",
            polygon.step(),
            bound * (curve.degree() / 2) as f64,
        );
    }
    table
}
