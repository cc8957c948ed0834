//! misconception: an origin is an origin, so that of the plane may stand for both

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
    let plane = Point::origin();
    let [first, second] = origins.map(|_| numbers(sum(&plane, terms)));
    let mut sides =
        Sides::new("").equal("both origins give one sum", first, second, Rounding::none());
    for (_, point) in terms {
        let alone = [(BigRational::from_ratio(1, 1), point.clone())];
        for _ in origins {
            sides = sides.equal(
                "a point alone is its own sum",
                numbers(sum(&plane, &alone)),
                numbers(point.clone()),
                Rounding::none(),
            );
        }
    }
    sides
}
