//! misconception: the factors come from the degree alone; the interval only says where the curve is defined

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
    let [n, below] = [n, n - 1].map(|degree| T::from_integer(degree as i64));
    [first * n.clone(), second * (n * below)]
}
