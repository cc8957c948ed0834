//! The sides of the library's triangle.

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::scalar::Scalar;

/// The control points of the left piece and of the right piece of the curve with the control points b, cut at α.
pub fn subdivided<T: Scalar>(b: &[Point<T, 2>], alpha: T) -> [Vec<Point<T, 2>>; 2] {
    let curve = BezierCurve::new(b.to_vec()).expect("at least one point");
    let triangle = curve.triangle(alpha);
    [
        triangle.left_side().cloned().collect(),
        triangle.right_side().cloned().collect(),
    ]
}
