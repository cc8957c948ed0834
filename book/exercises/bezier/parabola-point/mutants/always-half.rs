//! misconception: the last step takes the middle of the two points, whatever t is

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The point b(t).
pub fn point<T: Scalar>(b: &[Point<T, 2>; 3], t: T) -> Point<T, 2> {
    let between = |p: &Point<T, 2>, q: &Point<T, 2>, t: T| p.clone() + (q.clone() - p.clone()) * t;
    let first = between(&b[0], &b[1], t.clone());
    let second = between(&b[1], &b[2], t);
    between(&first, &second, T::from_ratio(1, 2))
}
