//! Both boxes of the library.

use cagd::affine::Point;
use cagd::bezier::BezierCurve;

/// The corners of the smallest box around the control points.
pub fn control_box(b: &[Point<f64, 2>; 4]) -> [Point<f64, 2>; 2] {
    let curve = BezierCurve::new(*b).expect("four points with finite coordinates");
    let bounds = curve.bounding_box();
    [*bounds.low(), *bounds.high()]
}

/// The corners of the smallest box around the curve over [0, 1].
pub fn tight_box(b: &[Point<f64, 2>; 4]) -> [Point<f64, 2>; 2] {
    let curve = BezierCurve::new(*b).expect("four points with finite coordinates");
    let bounds = curve.tight_bounding_box();
    [*bounds.low(), *bounds.high()]
}
