//! misconception: the ratio of the first coordinates is enough, so a line with B₁ = A₁ has no coordinates

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The weights of A and B.
pub fn coordinates<T: Scalar>(a: &Point<T, 2>, b: &Point<T, 2>, g: &Point<T, 2>) -> Option<[T; 2]> {
    let whole = b.clone() - a.clone();
    let part = g.clone() - a.clone();
    if whole[0].is_zero() {
        return None;
    }
    let beta = part[0].clone() / whole[0].clone();
    (whole * beta.clone() == part).then(|| [T::one() - beta.clone(), beta])
}
