//! One step of Chaikin's algorithm for an open polygon.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The polygon whose vertices are the cuts at 1/4 and 3/4 of every leg; empty if there is no leg.
pub fn chaikin<T: Scalar>(vertices: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    //@ solution
    let cut = |leg: &[Point<T, 2>], quarters: i64| {
        leg[0].clone() + (leg[1].clone() - leg[0].clone()) * T::from_ratio(quarters, 4)
    };
    vertices
        .windows(2)
        .flat_map(|leg| [cut(leg, 1), cut(leg, 3)])
        .collect()
    //@ starter
    //| // Nothing is cut yet.
    //| vertices.to_vec()
    //@ end
}
