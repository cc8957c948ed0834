//! A sum of Bernstein polynomials for the elevated curve.

use cagd::affine::{Point, Vector};
use cagd::bezier::{BezierCurve, bernstein};
use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// The point at t of the curve of a polygon; none if the polygon is empty.
fn point_at<T: Scalar>(polygon: &[Point<T, 2>], t: &T) -> Option<Point<T, 2>> {
    let curve = BezierCurve::new(polygon.to_vec()).ok()?;
    Some(curve.at(t.clone()))
}

/// Claims that `implementation` elevates the degree of the curve with the control points b, as far as it shows at t.
pub fn law<T: Scalar>(
    implementation: impl Fn(&[Point<T, 2>]) -> Vec<Point<T, 2>>,
    b: &[Point<T, 2>],
    t: &T,
) -> Sides<T> {
    let sides = Sides::new(format!("b = {b:?}, t = {t}"));
    let found = implementation(b);
    let coordinates = |polygon: &[Point<T, 2>]| {
        point_at(polygon, t).map_or(Vec::new(), |p| p.coordinates().to_vec())
    };
    let count = |points: usize| [T::from_integer(points as i64)];
    let n = found.len().max(1) - 1;
    let sum = found
        .iter()
        .enumerate()
        .fold(Vector::<T, 2>::zeros(), |sum, (i, point)| {
            sum + point.from_origin() * bernstein(n, i as i64, t.clone())
        });
    sides
        .equal(
            "one point more",
            count(found.len()),
            count(b.len() + 1),
            Rounding::none(),
        )
        .equal(
            "the same curve",
            sum.iter().cloned(),
            coordinates(b),
            Rounding::none(),
        )
}
