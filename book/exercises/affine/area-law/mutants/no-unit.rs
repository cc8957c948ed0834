//! misconception: the factor of affine maps says all about areas

use cagd::affine::{AffineMap, Point};
use cagd::law::{Rounding, Sides};
use cagd::scalar::BigRational;

/// Both sides of the law.
pub fn area_law(
    area: impl Fn(&Point<BigRational, 2>, &Point<BigRational, 2>, &Point<BigRational, 2>) -> BigRational,
    map: &AffineMap<BigRational, 2, 2>,
    triangle: &[Point<BigRational, 2>; 3],
) -> Sides<BigRational> {
    let [p, q, r] = triangle.each_ref().map(|corner| map.point(corner));
    let [a, b, c] = triangle;
    let determinant = map.determinant();
    Sides::new("").equal(
        "the factor",
        [area(&p, &q, &r)],
        [determinant * area(a, b, c)],
        Rounding::none(),
    )
}
