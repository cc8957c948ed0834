//! misconception: a function that is right for each point is right for all combinations

use cagd::affine::Point;
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

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
    let mut sides = Sides::new("");
    for (_, point) in terms {
        let alone = [(BigRational::from_ratio(1, 1), point.clone())];
        for origin in origins {
            sides = sides.equal(
                "a point alone is its own sum",
                numbers(sum(origin, &alone)),
                numbers(point.clone()),
                Rounding::none(),
            );
        }
    }
    sides
}
