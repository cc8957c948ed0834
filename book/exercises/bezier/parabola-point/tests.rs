use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Points = [Point<BigRational, 2>; 3];

fn points(coordinates: [[i64; 2]; 3]) -> Points {
    coordinates.map(|xy| Point::new(xy.map(|n| fraction(n, 1))))
}

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn probes() -> Vec<String> {
    let b = points([[0, 0], [2, 6], [10, 4]]);
    cagd::probes![
        answer::point(&b, fraction(0, 1)),
        answer::point(&b, fraction(1, 4)),
        answer::point(&b, fraction(3, 2)),
    ]
}

/// The claim that the answer's point is the library's.
fn compare(b: &Points, t: &BigRational) {
    let right = BezierCurve::new(b.to_vec()).expect("three points");
    let parameters = || (0..=32).map(|k| fraction(k, 32));
    claim("the point b(t)")
        .input(format!("b₀ = {}, b₁ = {}, b₂ = {}, t = {t}", b[0], b[1], b[2]))
        .picture(|| {
            Picture::new()
                .given(b.clone())
                .expected(parameters().map(|t| right.at(t)))
                .found(parameters().map(|t| answer::point(b, t)))
        })
        .equal(answer::point(b, t.clone()), right.at(t.clone()));
}

/// Why: the numbers are small enough to follow the three steps by hand.
#[test]
fn half_way() {
    compare(&points([[0, 0], [2, 4], [6, 0]]), &fraction(1, 2));
}

/// Why: a swapped t shows here first.
#[test]
fn both_ends() {
    let b = points([[0, 0], [2, 4], [6, 0]]);
    compare(&b, &fraction(0, 1));
    compare(&b, &fraction(1, 1));
}

proptest! {
    /// Why: it rejects what only fails for particular points.
    #[test]
    fn everywhere(b in any::<[[i8; 2]; 3]>(), t in -8..=16_i64) {
        compare(&points(b.map(|xy| xy.map(i64::from))), &fraction(t, 8));
    }
}
