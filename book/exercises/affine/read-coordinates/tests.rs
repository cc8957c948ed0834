use cagd::affine::Point;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn point(xy: [i64; 2]) -> Point<BigRational, 2> {
    Point::new(xy.map(|n| fraction(n, 1)))
}

fn probes() -> Vec<String> {
    let read = |a, b, g| answer::coordinates(&point(a), &point(b), &point(g));
    cagd::probes![
        read([0, 0], [4, 8], [3, 6]),
        read([0, 0], [4, 8], [-1, -2]),
        read([2, 0], [2, 5], [2, 4]),
        read([0, 0], [4, 0], [1, 3]),
        read([1, 1], [1, 1], [1, 1]),
    ]
}

/// The claim that the answer reads `expected`, the weight of B, off the three points.
fn compare(a: [i64; 2], b: [i64; 2], g: &Point<BigRational, 2>, expected: Option<BigRational>) {
    let (a, b) = (point(a), point(b));
    let expected = expected.map(|beta| [fraction(1, 1) - &beta, beta]);
    claim("the weights of A and B")
        .input(format!("A = {a}, B = {b}, G = {g}"))
        .picture(|| {
            Picture::new()
                .given([a.clone(), b.clone()])
                .given([g.clone()])
        })
        .equal(answer::coordinates(&a, &b, g), expected);
}

/// Why: at the ends, in the middle and three quarters of the way one knows the weights without a formula.
#[test]
fn between_the_points() {
    for (g, quarters) in [([0, 0], 0), ([8, 4], 4), ([4, 2], 2), ([6, 3], 3)] {
        compare([0, 0], [8, 4], &point(g), Some(fraction(quarters, 4)));
    }
}

/// Why: beyond a point the weight of the farther one is negative.
#[test]
fn outside_of_the_segment() {
    for (g, halves) in [([-4, -2], -1), ([12, 6], 3)] {
        compare([0, 0], [8, 4], &point(g), Some(fraction(halves, 2)));
    }
}

/// Why: on such lines one of the two coordinates tells nothing.
#[test]
fn vertical_and_level_lines() {
    compare([2, 0], [2, 6], &point([2, 4]), Some(fraction(2, 3)));
    compare([0, 2], [6, 2], &point([4, 2]), Some(fraction(2, 3)));
}

/// Why: each of these points agrees with a point of the line in one coordinate.
#[test]
fn beside_the_line() {
    compare([0, 0], [8, 4], &point([4, 3]), None);
    compare([2, 0], [2, 6], &point([3, 4]), None);
    compare([0, 2], [6, 2], &point([4, 1]), None);
}

/// Why: two equal points span no line.
#[test]
fn equal_points() {
    compare([1, 2], [1, 2], &point([1, 2]), None);
    compare([1, 2], [1, 2], &point([3, 4]), None);
}

proptest! {
    /// Why: a point with a known weight, on any line; it is found again.
    #[test]
    fn planted_weights(a in any::<[i8; 2]>(), b in any::<[i8; 2]>(), beta in -16..=16_i64) {
        let (a, b) = (a.map(i64::from), b.map(i64::from));
        let beta = fraction(beta, 8);
        let [x, y] = [0, 1].map(|k| fraction(a[k], 1) + &beta * fraction(b[k] - a[k], 1));
        compare(a, b, &Point::new([x, y]), (a != b).then_some(beta));
    }

    /// Why: any three points of a small grid; the determinant says whether they lie on a line.
    #[test]
    fn beside_any_line(a in [0..4_i64, 0..4], b in [0..4_i64, 0..4], g in [0..4_i64, 0..4]) {
        let determinant = (b[0] - a[0]) * (g[1] - a[1]) - (b[1] - a[1]) * (g[0] - a[0]);
        prop_assume!(determinant != 0);
        compare(a, b, &point(g), None);
    }
}
