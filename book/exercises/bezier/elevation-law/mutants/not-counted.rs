//! misconception: if the curve is the same, the degree was elevated; but then doing nothing is an elevation

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
    let coordinates = |polygon: &[Point<T, 2>]| {
        point_at(polygon, t).map_or(Vec::new(), |p| p.coordinates().to_vec())
    };
    sides.equal(
        "the same curve",
        coordinates(&found),
        coordinates(b),
        Rounding::none(),
    )
}
