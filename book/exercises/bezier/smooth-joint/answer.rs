//! Two Bézier curves with a common point and a common velocity.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The points c₀ and c₁ of the second piece, of degree m, for a C¹ joint.
///
/// The control points b, at least two, belong to the first piece; the pieces run over intervals of these lengths.
pub fn joint<T: Scalar>(b: &[Point<T, 2>], lengths: [T; 2], m: usize) -> [Point<T, 2>; 2] {
    let n = b.len() - 1;
    //@ solution
    let [h0, h1] = lengths;
    let ratio = T::from_ratio(n as i64, m as i64) * h1 / h0;
    let leg = b[n].clone() - b[n - 1].clone();
    [b[n].clone(), b[n].clone() + leg * ratio]
    //@ starter
    //| // The pieces meet, but the second one begins at rest.
    //| let _ = (lengths, m);
    //| [b[n].clone(), b[n].clone()]
    //@ end
}
