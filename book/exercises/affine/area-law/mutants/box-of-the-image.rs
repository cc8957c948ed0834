//! misconception: the factor is the area of the box around the image of the unit square

use cagd::affine::{AffineMap, Point};
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, OrderedScalar, Scalar};

/// Both sides of the law.
pub fn area_law(
    area: impl Fn(&Point<BigRational, 2>, &Point<BigRational, 2>, &Point<BigRational, 2>) -> BigRational,
    map: &AffineMap<BigRational, 2, 2>,
    triangle: &[Point<BigRational, 2>; 3],
) -> Sides<BigRational> {
    let unit = |x: i64, y: i64| Point::new([x, y].map(|n| BigRational::from_ratio(n, 1)));
    let half = BigRational::from_ratio(1, 2);
    let first = area(&unit(0, 0), &unit(1, 0), &unit(0, 1));
    let [p, q, r] = triangle.each_ref().map(|corner| map.point(corner));
    let [a, b, c] = triangle;
    let entry = |row: usize, column: usize| OrderedScalar::abs(&map.linear()[(row, column)]);
    let factor = (entry(0, 0) + entry(0, 1)) * (entry(1, 0) + entry(1, 1));
    Sides::new("")
        .equal("the unit triangle", [first], [half], Rounding::none())
        .equal(
            "the factor",
            [area(&p, &q, &r)],
            [factor * area(a, b, c)],
            Rounding::none(),
        )
}
