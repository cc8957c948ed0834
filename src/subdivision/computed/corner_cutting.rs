//! Worked numbers of corner cutting.

use super::Computed;
use crate::affine::Point;
use crate::bezier::binomial;
use crate::book::tex;
use crate::scalar::{BigRational, Scalar};
use crate::subdivision::ControlPolygon;

pub(super) const ALL: &[Computed] = &[
    ("chaikin_example", chaikin_example),
    ("lane_riesenfeld_masks", lane_riesenfeld_masks),
];

/// Two steps of Chaikin's algorithm for three points.
fn chaikin_example() -> String {
    let points =
        [[0, 0], [4, 8], [8, 0]].map(|p| Point::new(p.map(<BigRational as Scalar>::from_integer)));
    let mut polygon = ControlPolygon::open(points).expect("three points");
    let mut table = String::from("| step | vertices |\n|--:|---|\n");
    for step in 0..=2 {
        let vertices: Vec<String> = polygon
            .vertices()
            .iter()
            .map(|vertex| format!("${}$", tex::point(vertex, tex::fraction)))
            .collect();
        table += &format!("| {step} | {} |\n", vertices.join(", "));
        polygon = polygon.chaikin().expect("an open polygon with legs");
    }
    table
}

/// What one vertex 2ⁿ among zeros becomes, beside the row of Pascal's triangle.
fn lane_riesenfeld_masks() -> String {
    let mut table = String::from(
        "| degree $n$ | mask, times $2^n$ | row $n+1$ of Pascal's triangle |\n|--:|---|---|\n",
    );
    for degree in 1..=5_usize {
        let impulse = (0..2 * degree + 3).map(|i| {
            if i == degree + 1 {
                2_f64.powi(degree as i32)
            } else {
                0.0
            }
        });
        let refined = ControlPolygon::open(impulse)
            .and_then(|polygon| polygon.lane_riesenfeld(degree))
            .expect("more vertices than averagings");
        let mask = refined.vertices().iter().filter(|weight| **weight != 0.0);
        let row = (0..=degree as i64 + 1).map(|k| binomial::<f64>(degree + 1, k).to_string());
        table += &format!(
            "| {degree} | {} | {} |\n",
            mask.map(ToString::to_string).collect::<Vec<_>>().join(", "),
            row.collect::<Vec<_>>().join(", ")
        );
    }
    table
}
