//! misconception: a joint needs a direction, so if the last leg is a point, the leg before it counts

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The points c₀ and c₁ of the second piece, of degree m, for a C¹ joint.
pub fn joint<T: Scalar>(b: &[Point<T, 2>], lengths: [T; 2], m: usize) -> [Point<T, 2>; 2] {
    let n = b.len() - 1;
    let [h0, h1] = lengths;
    let ratio = T::from_ratio(n as i64, m as i64) * h1 / h0;
    let inner = b.iter().rev().find(|point| **point != b[n]);
    let leg = b[n].clone() - inner.unwrap_or(&b[n]).clone();
    [b[n].clone(), b[n].clone() + leg * ratio]
}
