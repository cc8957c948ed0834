//! misconception: the last vertex is joined to the first; but an open polygon has no leg there

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The polygon after one step.
pub fn chaikin<T: Scalar>(vertices: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    if vertices.len() < 2 {
        return Vec::new();
    }
    let next = vertices.iter().cycle().skip(1);
    vertices
        .iter()
        .zip(next)
        .flat_map(|(start, end)| {
            [1, 3].map(|quarters| {
                start.clone() + (end.clone() - start.clone()) * T::from_ratio(quarters, 4)
            })
        })
        .collect()
}
