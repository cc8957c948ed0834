//! misconception: the velocity at the joint depends on the degrees only; the lengths of the intervals drop out

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The points c₀ and c₁ of the second piece, of degree m, for a C¹ joint.
pub fn joint<T: Scalar>(b: &[Point<T, 2>], lengths: [T; 2], m: usize) -> [Point<T, 2>; 2] {
    let n = b.len() - 1;
    let _ = lengths;
    let ratio = T::from_ratio(n as i64, m as i64);
    let leg = b[n].clone() - b[n - 1].clone();
    [b[n].clone(), b[n].clone() + leg * ratio]
}
