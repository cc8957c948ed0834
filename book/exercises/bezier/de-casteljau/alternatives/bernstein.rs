//! As a sum with Bernstein polynomials.

use cagd::affine::{Point, Vector};
use cagd::bezier::bernstein_basis;
use cagd::scalar::Scalar;

/// The point b(t) of the Bézier curve with the control points b₀, …, bₙ, at least one.
pub fn point<T: Scalar>(b: &[Point<T, 2>], t: T) -> Point<T, 2> {
    let weights = bernstein_basis(b.len() - 1, t);
    let terms = b
        .iter()
        .zip(weights)
        .map(|(point, w)| point.from_origin() * w);
    Point::origin() + terms.fold(Vector::<T, 2>::zeros(), |sum, term| sum + term)
}
