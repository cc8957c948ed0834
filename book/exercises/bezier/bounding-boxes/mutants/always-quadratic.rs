//! misconception: the derivative of a cubic is quadratic, so the formula with the root always applies

use cagd::affine::Point;
use cagd::bezier::BezierCurve;

type Plane = Point<f64, 2>;

/// The corners of the smallest box around some points, at least one: smallest coordinates, largest coordinates.
fn corners(points: &[Plane]) -> [Plane; 2] {
    let extreme = |choose: fn(f64, f64) -> f64| {
        let coordinate = |k: usize| points.iter().map(|p| p[k]).fold(points[0][k], choose);
        Point::new([coordinate(0), coordinate(1)])
    };
    [extreme(f64::min), extreme(f64::max)]
}

/// The corners of the smallest box around the control points.
pub fn control_box(b: &[Plane; 4]) -> [Plane; 2] {
    corners(b)
}

/// The corners of the smallest box around the curve over [0, 1].
pub fn tight_box(b: &[Plane; 4]) -> [Plane; 2] {
    let curve = BezierCurve::new(*b).expect("four points with finite coordinates");
    let mut points = vec![b[0], b[3]];
    for k in 0..2 {
        for t in zeros([0, 1, 2].map(|i| b[i + 1][k] - b[i][k])) {
            if 0.0 < t && t < 1.0 {
                points.push(curve.at(t));
            }
        }
    }
    corners(&points)
}

/// The zeros of the quadratic polynomial with the control values d.
fn zeros([d0, d1, d2]: [f64; 3]) -> Vec<f64> {
    let a = d0 - 2.0 * d1 + d2;
    let h = d1 - d0;
    let discriminant = h * h - a * d0;
    let root = discriminant.sqrt();
    vec![(-h - root) / a, (-h + root) / a]
}
