//! misconception: the factor of the second derivative is n², because each derivative brings the factor n

use cagd::affine::{Point, Vector};
use cagd::bezier::BezierCurve;
use cagd::scalar::Scalar;

/// The velocity and the acceleration at u of a curve of degree n ≥ 2.
pub fn motion<T: Scalar>(curve: &BezierCurve<Point<T, 2>>, u: T) -> [Vector<T, 2>; 2] {
    let n = curve.degree();
    let triangle = curve.triangle(u);
    let point = |level: usize, index: usize| triangle.point(level, index).clone();
    let first = point(n - 1, 1) - point(n - 1, 0);
    let second = (point(n - 2, 2) - point(n - 2, 1)) - (point(n - 2, 1) - point(n - 2, 0));
    let h = curve.domain().length();
    let n = T::from_integer(n as i64);
    let factor = n / h;
    [first * factor.clone(), second * (factor.clone() * factor)]
}
