//! Columns with c first, and from each of them the rest with d.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

fn step<T: Scalar>(column: &[Point<T, 2>], x: &T) -> Vec<Point<T, 2>> {
    let pairs = column.windows(2);
    pairs.map(|p| p[0].lerp(&p[1], x.clone())).collect()
}

/// The control points of t ↦ b((1 − t)c + td) for the curve with the control points b, at least one.
pub fn points_over<T: Scalar>(b: &[Point<T, 2>], c: T, d: T) -> Vec<Point<T, 2>> {
    let mut column = b.to_vec();
    let mut points = Vec::new();
    while !column.is_empty() {
        let mut rest = column.clone();
        while rest.len() > 1 {
            rest = step(&rest, &d);
        }
        points.push(rest[0].clone());
        column = step(&column, &c);
    }
    points.reverse();
    points
}
