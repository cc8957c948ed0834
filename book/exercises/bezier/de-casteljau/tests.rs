use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type RationalPoint = Point<BigRational, 2>;

fn points(coordinates: &[[i64; 2]]) -> Vec<RationalPoint> {
    let whole = |xy: &[i64; 2]| Point::new(xy.map(|n| fraction(n, 1)));
    coordinates.iter().map(whole).collect()
}

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

const CUBIC: [[i64; 2]; 4] = [[0, 0], [0, 4], [4, 4], [4, 0]];

fn probes() -> Vec<String> {
    let cubic = points(&CUBIC);
    cagd::probes![
        answer::point(&cubic, fraction(0, 1)),
        answer::point(&cubic, fraction(1, 4)),
        answer::point(&cubic, fraction(3, 2)),
        answer::point(
            &points(&[[0, 0], [2, 6], [10, 4], [3, 3], [1, 8]]),
            fraction(1, 2)
        ),
        answer::point(&points(&[[2, 6]]), fraction(1, 3)),
    ]
}

/// The claim that the answer's point is the library's.
fn compare(b: &[RationalPoint], t: &BigRational) {
    let right = BezierCurve::new(b.to_vec()).expect("at least one point");
    let parameters = || (0..=32).map(|k| fraction(k, 32));
    claim(format!("the point b(t) of degree {}", b.len() - 1))
        .input(format!("b = {b:?}, t = {t}"))
        .picture(|| {
            Picture::new()
                .given(b.to_vec())
                .expected(parameters().map(|t| right.at(t)))
                .found(parameters().map(|t| answer::point(b, t)))
        })
        .equal(answer::point(b, t.clone()), right.at(t.clone()));
}

/// Why: the numbers are those of the book's example, so each step can be followed.
#[test]
fn the_cubic_of_the_book() {
    compare(&points(&CUBIC), &fraction(1, 2));
    compare(&points(&CUBIC), &fraction(1, 4));
}

/// Why: a list of one point needs no step at all.
#[test]
fn a_single_point() {
    compare(&points(&[[3, -5]]), &fraction(2, 3));
}

#[test]
fn outside_of_the_interval() {
    compare(&points(&CUBIC), &fraction(-1, 2));
    compare(&points(&CUBIC), &fraction(3, 2));
}

proptest! {
    /// Why: it tries every degree up to 7, and repeated points.
    #[test]
    fn every_degree(b in prop::collection::vec([-4..=4_i64, -4..=4], 1..=8), t in 0..=8_i64) {
        compare(&points(&b), &fraction(t, 8));
    }
}
