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
    cagd::probes![
        answer::stretched(&point([2, 1]), &point([1, 4]), fraction(2, 1)),
        answer::stretched(&point([2, 1]), &point([-3, 0]), fraction(1, 2)),
        answer::stretched(&point([2, 1]), &point([0, 0]), fraction(-1, 1)),
    ]
}

/// The claim that `p`, seen from the centre, is stretched by `factor`.
fn compare(p: [i64; 2], centre: [i64; 2], factor: &BigRational) {
    let (given, from) = (point(p), point(centre));
    let coordinate = |k: usize| fraction(centre[k], 1) + factor * fraction(p[k] - centre[k], 1);
    let expected = Point::new([coordinate(0), coordinate(1)]);
    let found = || answer::stretched(&given, &from, factor.clone());
    claim("the stretched point")
        .input(format!(
            "P = {given}, centre O = {from}, factor λ = {factor}"
        ))
        .picture(|| {
            Picture::new()
                .given([from.clone(), given.clone()])
                .expected([expected.clone()])
                .found([found()])
        })
        .equal(found(), expected.clone());
}

/// Why: twice a point from the origin, where one may forget the centre.
#[test]
fn from_the_origin() {
    compare([2, 1], [0, 0], &fraction(2, 1));
}

/// Why: the same point and factor from another centre give another point.
#[test]
fn from_another_centre() {
    compare([2, 0], [1, 0], &fraction(2, 1));
}

/// Why: the one point that no factor moves.
#[test]
fn the_centre_stays() {
    for factor in [3, 1, 0, -2] {
        compare([4, -1], [4, -1], &fraction(factor, 1));
    }
}

/// Why: three factors for which one knows the answer without a formula.
#[test]
fn the_factors_one_zero_and_minus_one() {
    for factor in [1, 0, -1] {
        compare([3, 5], [1, 2], &fraction(factor, 1));
    }
}

proptest! {
    /// Why: any point, centre and factor.
    #[test]
    fn everywhere(p in any::<[i8; 2]>(), centre in any::<[i8; 2]>(), factor in -12..=12_i64) {
        compare(p.map(i64::from), centre.map(i64::from), &fraction(factor, 4));
    }
}
