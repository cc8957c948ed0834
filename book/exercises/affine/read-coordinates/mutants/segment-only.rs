//! misconception: weights are shares, so a point beyond A or B has none

use cagd::affine::Point;
use cagd::scalar::OrderedScalar;

/// The weights of A and B.
pub fn coordinates<T: OrderedScalar>(
    a: &Point<T, 2>,
    b: &Point<T, 2>,
    g: &Point<T, 2>,
) -> Option<[T; 2]> {
    let whole = b.clone() - a.clone();
    let part = g.clone() - a.clone();
    let k = (0..2).find(|&k| !whole[k].is_zero())?;
    let beta = part[k].clone() / whole[k].clone();
    let is_share = T::zero() <= beta && beta <= T::one();
    (is_share && whole * beta.clone() == part).then(|| [T::one() - beta.clone(), beta])
}
