//! misconception: coordinates are ratios of lengths, and lengths are never negative

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
    let alpha = T::one() - beta.clone();
    (whole * beta.clone() == part).then(|| [alpha.abs(), beta.abs()])
}
