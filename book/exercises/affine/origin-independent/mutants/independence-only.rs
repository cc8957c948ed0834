//! misconception: independence of the origin is all that a sum must fulfil

use cagd::affine::Point;
use cagd::law::{Rounding, Sides};
use cagd::scalar::BigRational;

/// Both sides of the law.
pub fn origin_independent(
    sum: impl Fn(
        &Point<BigRational, 2>,
        &[(BigRational, Point<BigRational, 2>)],
    ) -> Point<BigRational, 2>,
    terms: &[(BigRational, Point<BigRational, 2>)],
    origins: [&Point<BigRational, 2>; 2],
) -> Sides<BigRational> {
    let numbers = |point: Point<BigRational, 2>| point.coordinates().to_vec();
    let [first, second] = origins.map(|origin| numbers(sum(origin, terms)));
    Sides::new("").equal("both origins give one sum", first, second, Rounding::none())
}
