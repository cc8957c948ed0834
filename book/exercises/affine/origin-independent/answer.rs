//! The law that an affine combination does not depend on the origin.

use cagd::affine::Point;
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of: the sum of the terms (λᵢ, Pᵢ), whose weights sum to 1, is the same from both origins,
/// and each Pᵢ alone, with the weight 1, is its own sum from both origins.
pub fn origin_independent(
    sum: impl Fn(
        &Point<BigRational, 2>,
        &[(BigRational, Point<BigRational, 2>)],
    ) -> Point<BigRational, 2>,
    terms: &[(BigRational, Point<BigRational, 2>)],
    origins: [&Point<BigRational, 2>; 2],
) -> Sides<BigRational> {
    //@ solution
    let numbers = |point: Point<BigRational, 2>| point.coordinates().to_vec();
    let [first, second] = origins.map(|origin| numbers(sum(origin, terms)));
    let input = format!("{terms:?} from {origins:?}");
    let mut sides =
        Sides::new(input).equal("both origins give one sum", first, second, Rounding::none());
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
    //@ starter
    //| // This asks only for what the first point is alone, from the first origin.
    //| let point = terms[0].1.clone();
    //| let alone = [(BigRational::from_ratio(1, 1), point.clone())];
    //| Sides::new("").equal(
    //|     "the first point alone is its own sum",
    //|     sum(origins[0], &alone).coordinates().to_vec(),
    //|     point.coordinates().to_vec(),
    //|     Rounding::none(),
    //| )
    //@ end
}
