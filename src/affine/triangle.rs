//! Areas of triangles with a sign.

use super::{Affine, Point, Vector};
use crate::scalar::Scalar;

/// The determinant det(v, w) of two vectors of the plane: the area of their parallelogram, with a sign.
///
/// ```text
/// det(v, w) = v₁·w₂ − v₂·w₁
/// ```
///
/// It is positive if w lies to the left of v, and 0 if both have one direction or opposite ones.
///
/// # Examples
///
/// ```
/// use cagd::affine::{Vector, plane_determinant};
///
/// let [v, w] = [[2.0, 1.0], [1.0, 3.0]].map(Vector::from);
/// assert_eq!(plane_determinant(&v, &w), 5.0);
/// assert_eq!(plane_determinant(&w, &v), -5.0);
/// ```
#[must_use]
pub fn plane_determinant<T: Scalar>(v: &Vector<T, 2>, w: &Vector<T, 2>) -> T {
    v[0].clone() * w[1].clone() - v[1].clone() * w[0].clone()
}

/// The signed area \[a b c\] of a triangle: positive if its corners go round counterclockwise.
///
/// ```text
/// [a b c] = ½·det(b − a, c − a)
/// ```
///
/// It is 0 exactly if the three points lie on a line. In floating point it passes four roundings;
/// use [`Orient`](super::Orient) where only its sign matters.
///
/// # Examples
///
/// ```
/// use cagd::affine::{Point, signed_area};
///
/// let [a, b, c] = [[0.0, 0.0], [2.0, 1.0], [1.0, 3.0]].map(Point::new);
/// assert_eq!(signed_area(&a, &b, &c), 2.5);
/// assert_eq!(signed_area(&a, &c, &b), -2.5, "clockwise");
/// assert_eq!(signed_area(&a, &b, &b), 0.0);
/// ```
#[must_use]
pub fn signed_area<T: Scalar>(a: &Point<T, 2>, b: &Point<T, 2>, c: &Point<T, 2>) -> T {
    plane_determinant(&b.difference(a), &c.difference(a)) * T::from_ratio(1, 2)
}
