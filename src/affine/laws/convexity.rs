//! Laws of convex sets.

use super::magnitudes::largest;
use crate::affine::{Affine, Point, signed_area};
use crate::law::{Rounding, Sides};
use crate::scalar::OrderedScalar;

/// `affine-convex-set-and-hull`: the convex hull of finitely many points is convex, contains all their convex combinations,
/// and is the smallest such set, because its vertices are among the points.
///
/// `implementation(points)` must give the vertices of the hull, counterclockwise. The weights, one a point, must not be
/// negative, and not all be 0; they are divided by their sum.
///
/// # Rounding
///
/// The combination passes n + 2 roundings a term, so it is off by that much of s, the largest coordinate. A signed area passes
/// four more, and its terms are at most 4·s².
pub fn convex_set_and_hull<T: OrderedScalar>(
    implementation: impl Fn(&[Point<T, 2>]) -> Vec<Point<T, 2>>,
    points: &[Point<T, 2>],
    weights: &[T],
) -> Sides<T> {
    let vertices = implementation(points);
    let total = weights.iter().fold(T::zero(), |sum, w| sum + w.clone());
    let combination: Point<T, 2> = Point::from_fn(|k| {
        let terms = std::iter::zip(weights, points);
        let sum = terms.fold(T::zero(), |sum, (w, p)| sum + w.clone() * p[k].clone());
        sum / total.clone()
    });
    let count = vertices.len();
    let at = |i: usize| &vertices[i % count];
    let size = largest(points.iter().flat_map(Point::coordinates));
    let rounding = Rounding::new(points.len() + 8, 8.0 * size * size);
    let to_the_left = |point: &Point<T, 2>| -> Vec<T> {
        (0..count)
            .map(|i| signed_area(at(i), at(i + 1), point))
            .collect()
    };
    let all = |points: &[Point<T, 2>]| -> Vec<T> { points.iter().flat_map(&to_the_left).collect() };
    let nothing = |numbers: &[T]| vec![T::zero(); numbers.len()];
    let (of_combination, of_points) = (to_the_left(&combination), all(points));
    let is_given = |vertex: &Point<T, 2>| points.contains(vertex);
    Sides::new(format!("points {points:?}, weights {weights:?}"))
        .at_most(
            "the combination is to the left of each side, or on it",
            nothing(&of_combination),
            of_combination,
            rounding,
        )
        .at_most(
            "each of the points is to the left of each side, or on it",
            nothing(&of_points),
            of_points,
            rounding,
        )
        .equal(
            "the vertices are among the points",
            vertices
                .iter()
                .map(|vertex| T::from_integer(i64::from(is_given(vertex)))),
            vec![T::one(); count],
            Rounding::none(),
        )
        .equal(
            "the hull of the hull is the hull",
            implementation(&vertices)
                .iter()
                .flat_map(|v| v.coordinates().to_vec()),
            vertices.iter().flat_map(|v| v.coordinates().to_vec()),
            Rounding::none(),
        )
}
