//! The point b(t) of a parabola, by three linear interpolations.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The point b(t) of the quadratic Bézier curve with the control points b₀, b₁, b₂.
pub fn point<T: Scalar>(b: &[Point<T, 2>; 3], t: T) -> Point<T, 2> {
    //@ solution
    let between = |p: &Point<T, 2>, q: &Point<T, 2>| p.clone() + (q.clone() - p.clone()) * t.clone();
    between(&between(&b[0], &b[1]), &between(&b[1], &b[2]))
    //@ starter
    //| // This is the point for t = 0 only.
    //| let _ = t;
    //| b[0].clone()
    //@ end
}
