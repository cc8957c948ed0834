//! The law that determines the signed area of triangles.

use cagd::affine::{AffineMap, Point};
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};

/// Both sides of: the triangle (0, 0), (1, 0), (0, 1) has the area ½, and
/// the map multiplies the area of the triangle by its determinant.
pub fn area_law(
    area: impl Fn(&Point<BigRational, 2>, &Point<BigRational, 2>, &Point<BigRational, 2>) -> BigRational,
    map: &AffineMap<BigRational, 2, 2>,
    triangle: &[Point<BigRational, 2>; 3],
) -> Sides<BigRational> {
    //@ solution
    let unit = |x: i64, y: i64| Point::new([x, y].map(|n| BigRational::from_ratio(n, 1)));
    let half = BigRational::from_ratio(1, 2);
    let [a, b, c] = triangle;
    let images = area(&map.point(a), &map.point(b), &map.point(c));
    Sides::new(format!("the triangle {triangle:?}"))
        .equal(
            "the unit triangle",
            [area(&unit(0, 0), &unit(1, 0), &unit(0, 1))],
            [half],
            Rounding::none(),
        )
        .equal(
            "the factor",
            [images],
            [map.determinant() * area(a, b, c)],
            Rounding::none(),
        )
    //@ starter
    //| // This is only the half of it.
    //| let _ = (map, triangle);
    //| let unit = |x: i64, y: i64| Point::new([x, y].map(|n| BigRational::from_ratio(n, 1)));
    //| let half = BigRational::from_ratio(1, 2);
    //| let found = area(&unit(0, 0), &unit(1, 0), &unit(0, 1));
    //| Sides::new("").equal("the unit triangle", [found], [half], Rounding::none())
    //@ end
}
