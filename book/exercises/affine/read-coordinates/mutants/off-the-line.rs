//! misconception: one of the two coordinates gives the ratio, so G need not be tested further

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The weights of A and B.
pub fn coordinates<T: Scalar>(a: &Point<T, 2>, b: &Point<T, 2>, g: &Point<T, 2>) -> Option<[T; 2]> {
    let whole = b.clone() - a.clone();
    let part = g.clone() - a.clone();
    let k = (0..2).find(|&k| !whole[k].is_zero())?;
    let beta = part[k].clone() / whole[k].clone();
    Some([T::one() - beta.clone(), beta])
}
