//! misconception: what has no leg cannot change, so a single vertex stays; but the new vertices are cuts of legs, and without a leg there are none

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The polygon after one step.
pub fn chaikin<T: Scalar>(vertices: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let cut = |leg: &[Point<T, 2>], quarters: i64| {
        leg[0].clone() + (leg[1].clone() - leg[0].clone()) * T::from_ratio(quarters, 4)
    };
    if vertices.len() < 2 {
        return vertices.to_vec();
    }
    vertices
        .windows(2)
        .flat_map(|leg| [cut(leg, 1), cut(leg, 3)])
        .collect()
}
