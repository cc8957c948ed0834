//! misconception: if the first coordinates of the two sums agree, the sums do

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
    let [first, second] = origins.map(|origin| numbers(sum(origin, terms)));
    let mut sides = Sides::new("").equal(
        "both origins give one sum",
        [first[0].clone()],
        [second[0].clone()],
        Rounding::none(),
    );
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
