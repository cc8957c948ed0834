//! misconception: for A = B = G the weights 1 and 0 are right, so they are the answer

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The weights of A and B.
pub fn coordinates<T: Scalar>(a: &Point<T, 2>, b: &Point<T, 2>, g: &Point<T, 2>) -> Option<[T; 2]> {
    let whole = b.clone() - a.clone();
    let part = g.clone() - a.clone();
    let Some(k) = (0..2).find(|&k| !whole[k].is_zero()) else {
        return (a == g).then(|| [T::one(), T::zero()]);
    };
    let beta = part[k].clone() / whole[k].clone();
    (whole * beta.clone() == part).then(|| [T::one() - beta.clone(), beta])
}
