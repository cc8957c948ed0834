//! misconception: the three parts of a leg are equal; but the cuts are at a quarter and three quarters, so the middle part is half of the leg

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The polygon after one step.
pub fn chaikin<T: Scalar>(vertices: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let cut = |leg: &[Point<T, 2>], thirds: i64| {
        leg[0].clone() + (leg[1].clone() - leg[0].clone()) * T::from_ratio(thirds, 3)
    };
    vertices
        .windows(2)
        .flat_map(|leg| [cut(leg, 1), cut(leg, 2)])
        .collect()
}
