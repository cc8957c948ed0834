//! The factor as the determinant of the images of two vectors.

use cagd::affine::{AffineMap, Point};
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

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
    let unit_vector = |x: i64, y: i64| unit(x, y).from_origin();
    let (v, w) = (
        map.vector(&unit_vector(1, 0)),
        map.vector(&unit_vector(0, 1)),
    );
    let factor = cagd::affine::plane_determinant(&v, &w);
    Sides::new("")
        .equal("the unit triangle", [first], [half], Rounding::none())
        .equal(
            "the factor",
            [area(&p, &q, &r) - factor * area(a, b, c)],
            [BigRational::default()],
            Rounding::none(),
        )
}
