use cagd::affine::{AffineMap, Point, signed_area};
use cagd::check::claim;
use cagd::law::Sides;
use cagd::scalar::{BigRational, OrderedScalar, Scalar};
use proptest::prelude::*;

type Exact = Point<BigRational, 2>;
type Map = AffineMap<BigRational, 2, 2>;
type Area = fn(&Exact, &Exact, &Exact) -> BigRational;

fn whole(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

fn triangle(corners: [[i64; 2]; 3]) -> [Exact; 3] {
    corners.map(|xy| Point::new(xy.map(whole)))
}

fn map(rows: [[i64; 2]; 2], translation: [i64; 2]) -> Map {
    AffineMap::new(rows.map(|row| row.map(whole)), translation.map(whole))
}

fn shear() -> Map {
    map([[1, 3], [0, 1]], [0, 0])
}

fn stretching() -> Map {
    map([[2, 0], [0, 3]], [0, 0])
}

fn reflection() -> Map {
    map([[0, 1], [1, 0]], [0, 0])
}

fn translation() -> Map {
    map([[1, 0], [0, 1]], [2, 5])
}

fn projection() -> Map {
    map([[1, 0], [0, 0]], [0, 4])
}

fn seven_times(a: &Exact, b: &Exact, c: &Exact) -> BigRational {
    signed_area(a, b, c) * whole(7)
}

fn without_sign(a: &Exact, b: &Exact, c: &Exact) -> BigRational {
    OrderedScalar::abs(&signed_area(a, b, c))
}

/// Half of the box around the triangle.
fn half_the_box(a: &Exact, b: &Exact, c: &Exact) -> BigRational {
    let extent = |k: usize| {
        let [x, y, z] = [a, b, c].map(|p| p[k].clone());
        let low = OrderedScalar::min(OrderedScalar::min(x.clone(), y.clone()), z.clone());
        OrderedScalar::max(OrderedScalar::max(x, y), z) - low
    };
    extent(0) * extent(1) / whole(2)
}

/// Right as long as the first corner is the origin.
fn corners_as_vectors(_: &Exact, b: &Exact, c: &Exact) -> BigRational {
    (&b[0] * &c[1] - &b[1] * &c[0]) / whole(2)
}

/// A function that knows the area of one triangle only.
fn always_a_half(_: &Exact, _: &Exact, _: &Exact) -> BigRational {
    BigRational::from_ratio(1, 2)
}

/// Right but for the triangle of the tests.
fn wrong_for_one_triangle(a: &Exact, b: &Exact, c: &Exact) -> BigRational {
    let right = signed_area(a, b, c);
    if [a, b, c] == triangle(EXAMPLE).each_ref() {
        right + whole(1)
    } else {
        right
    }
}

/// The triangle of most tests.
const EXAMPLE: [[i64; 2]; 3] = [[0, 0], [4, 0], [1, 2]];

fn judge(area: Area, map: &Map) -> Sides<BigRational> {
    answer::area_law(area, map, &triangle(EXAMPLE))
}

fn probes() -> Vec<String> {
    let says = |area: Area, map: Map| {
        if judge(area, &map).judge().is_ok() {
            "holds"
        } else {
            "violated"
        }
    };
    cagd::probes![
        says(signed_area, shear()),
        says(signed_area, stretching()),
        says(signed_area, reflection()),
        says(signed_area, projection()),
        says(seven_times, stretching()),
        says(without_sign, reflection()),
        says(half_the_box, shear()),
        says(corners_as_vectors, translation()),
        says(always_a_half, stretching()),
        says(wrong_for_one_triangle, stretching()),
    ]
}

fn must_hold(name: &str, map: &Map) {
    claim(format!("the law for the right area and a {name}")).law(&judge(signed_area, map));
}

fn must_be_violated(name: &str, area: Area, map: &Map) {
    let sides = judge(area, map);
    claim(format!("the law for {name}"))
        .input(format!(
            "the triangle {EXAMPLE:?}, the map with the linear part {} and the translation {}",
            map.linear(),
            map.translation()
        ))
        .holds(
            sides.judge().is_err(),
            "a claim that does not hold",
            "the law holds",
        );
}

/// Why: a shear and a translation keep areas, so one sees both sides without computing.
#[test]
fn maps_that_keep_areas() {
    must_hold("shear", &shear());
    must_hold("translation", &translation());
}

/// Why: the factors 6, −1 and 0.
#[test]
fn maps_that_change_areas() {
    must_hold("stretching", &stretching());
    must_hold("reflection", &reflection());
    must_hold("projection", &projection());
}

/// Seven times the area is multiplied by the same factors; the unit triangle tells.
#[test]
fn the_unit_counts() {
    must_be_violated("seven times the area", seven_times, &stretching());
}

/// An area without its sign is found by a reflection.
#[test]
fn the_sign_counts() {
    must_be_violated("the area without its sign", without_sign, &reflection());
}

/// Why: half of the box around a triangle is right for triangles along the axes; a shear makes it larger.
#[test]
fn a_shear_counts() {
    must_be_violated(
        "half of the box around the triangle",
        half_the_box,
        &shear(),
    );
}

/// Why: a determinant of coordinates is right if the first corner is the origin; a translation moves it away.
#[test]
fn a_translation_counts() {
    must_be_violated(
        "the determinant of two corners",
        corners_as_vectors,
        &translation(),
    );
}

/// Why: this function is right for the unit triangle, and for every map that keeps areas.
#[test]
fn the_factor_counts() {
    must_be_violated(
        "the function that is always ½",
        always_a_half,
        &stretching(),
    );
}

/// The second claim is about the triangle that is given, and not about the unit triangle once more.
#[test]
fn the_given_triangle_counts() {
    must_be_violated(
        "a function that is wrong for this triangle",
        wrong_for_one_triangle,
        &stretching(),
    );
}

proptest! {
    /// Why: the right area may not be rejected, for whatever map and triangle.
    #[test]
    fn the_right_area_always_passes(
        rows in [[-9..=9_i64, -9..=9_i64], [-9..=9_i64, -9..=9_i64]], moved in [-9..=9_i64, -9..=9_i64],
        corners in [[-9..=9_i64, -9..=9_i64], [-9..=9_i64, -9..=9_i64], [-9..=9_i64, -9..=9_i64]],
    ) {
        claim("the law for the right area")
            .law(&answer::area_law(signed_area, &map(rows, moved), &triangle(corners)));
    }
}
