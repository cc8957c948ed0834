//! misconception: a curve has to begin and to end at the given ends, so these are kept; but they are corners, too, and Chaikin cuts them off

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The polygon after one step.
pub fn chaikin<T: Scalar>(vertices: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let cut = |leg: &[Point<T, 2>], quarters: i64| {
        leg[0].clone() + (leg[1].clone() - leg[0].clone()) * T::from_ratio(quarters, 4)
    };
    let mut cuts: Vec<Point<T, 2>> = vertices
        .windows(2)
        .flat_map(|leg| [cut(leg, 1), cut(leg, 3)])
        .collect();
    if let [first, .., last] = cuts.as_mut_slice() {
        *first = vertices[0].clone();
        *last = vertices[vertices.len() - 1].clone();
    }
    cuts
}
