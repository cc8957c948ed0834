//! misconception: the weight of the first point is t, so the curve runs from b₂ to b₀

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The point b(t).
pub fn point<T: Scalar>(b: &[Point<T, 2>; 3], t: T) -> Point<T, 2> {
    let between = |p: &Point<T, 2>, q: &Point<T, 2>| q.clone() + (p.clone() - q.clone()) * t.clone();
    between(&between(&b[0], &b[1]), &between(&b[1], &b[2]))
}
