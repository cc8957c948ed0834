//! Barycentric coordinates on a line of the plane.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The weights (α, β) with α + β = 1 and G = αA + βB.
///
/// `None` if A = B, or if G does not lie on the line through A and B.
pub fn coordinates<T: Scalar>(a: &Point<T, 2>, b: &Point<T, 2>, g: &Point<T, 2>) -> Option<[T; 2]> {
    //@ solution
    let whole = b.clone() - a.clone();
    let part = g.clone() - a.clone();
    let k = (0..2).find(|&k| !whole[k].is_zero())?;
    let beta = part[k].clone() / whole[k].clone();
    (whole * beta.clone() == part).then(|| [T::one() - beta.clone(), beta])
    //@ starter
    //| // These are the weights of G = A only.
    //| let _ = (b, g);
    //| (a == g).then(|| [T::one(), T::zero()])
    //@ end
}
