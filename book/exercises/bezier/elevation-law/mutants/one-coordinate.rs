//! misconception: one coordinate is enough, since the other one is treated alike

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
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
    let coordinates =
        |polygon: &[Point<T, 2>]| point_at(polygon, t).map_or(Vec::new(), |p| vec![p[0].clone()]);
    let count = |points: usize| [T::from_integer(points as i64)];
    sides
        .equal(
            "one point more",
            count(found.len()),
            count(b.len() + 1),
            Rounding::none(),
        )
        .equal(
            "the same curve",
            coordinates(&found),
            coordinates(b),
            Rounding::none(),
        )
}
