use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Points = Vec<Point<BigRational, 2>>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn points(coordinates: &[[i64; 2]]) -> Points {
    let point = |xy: &[i64; 2]| Point::new(xy.map(|n| fraction(n, 1)));
    coordinates.iter().map(point).collect()
}

const PARABOLA: [[i64; 2]; 3] = [[0, 0], [4, 8], [8, 0]];

fn probes() -> Vec<String> {
    cagd::probes![
        answer::points_over(&points(&PARABOLA), fraction(1, 4), fraction(3, 4)),
        answer::points_over(&points(&[[0, 0], [6, 12]]), fraction(1, 2), fraction(2, 1)),
        answer::points_over(&points(&[[7, 1]]), fraction(1, 2), fraction(2, 1)),
    ]
}

/// The claim that the answer gives these points.
fn compare(b: &[[i64; 2]], c: &BigRational, d: &BigRational, right: &Points) {
    let found = || answer::points_over(&points(b), c.clone(), d.clone());
    claim("the control points over the other interval")
        .input(format!("control points {b:?}, c = {c}, d = {d}"))
        .picture(|| {
            Picture::new()
                .given(points(b))
                .expected(right.clone())
                .found(found())
        })
        .equal(found(), right.clone());
}

/// Why: the blossom of a segment is its point at the one argument.
#[test]
fn a_segment() {
    compare(
        &[[0, 0], [6, 12]],
        &fraction(1, 2),
        &fraction(2, 1),
        &points(&[[3, 6], [12, 24]]),
    );
}

/// Why: p(x₁, x₂) = (4x₁ + 4x₂, 8x₁ + 8x₂ − 16x₁x₂) can be computed by hand.
#[test]
fn a_parabola() {
    let whole = |n| fraction(n, 1);
    compare(&PARABOLA, &whole(0), &whole(1), &points(&PARABOLA));
    compare(
        &PARABOLA,
        &fraction(1, 4),
        &fraction(3, 4),
        &points(&[[2, 3], [4, 5], [6, 3]]),
    );
    compare(
        &PARABOLA,
        &whole(1),
        &whole(2),
        &points(&[[8, 0], [12, -8], [16, -32]]),
    );
}

/// Why: from 1 to 0 the polygon runs backwards, and over one number it is a point.
#[test]
fn backwards_and_nowhere() {
    let whole = |n| fraction(n, 1);
    compare(
        &PARABOLA,
        &whole(1),
        &whole(0),
        &points(&[[8, 0], [4, 8], [0, 0]]),
    );
    compare(
        &PARABOLA,
        &fraction(1, 2),
        &fraction(1, 2),
        &points(&[[4, 4]; 3]),
    );
}

/// Why: degree 0 has a blossom without arguments.
#[test]
fn a_single_point() {
    compare(
        &[[7, 1]],
        &fraction(1, 3),
        &fraction(5, 1),
        &points(&[[7, 1]]),
    );
}

proptest! {
    // Fewer cases, for each compares two polynomials.
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Why: it compares the curves and not the points, in every degree and over any interval.
    #[test]
    fn the_same_curve(
        b in prop::collection::vec(any::<[i8; 2]>(), 1..=5),
        c in -8..=12_i64,
        d in -8..=12_i64,
    ) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let (c, d) = (fraction(c, 4), fraction(d, 4));
        let curve = BezierCurve::new(points(&b)).expect("at least one point");
        let found = answer::points_over(&points(&b), c.clone(), d.clone());
        claim("the number of control points").equal(found.len(), b.len());
        let piece = BezierCurve::new(found).expect("at least one point");
        // Polynomials of degree n that agree at n + 1 parameters are equal.
        for k in 0..b.len() as i64 {
            let t = fraction(k, 3);
            let u = (fraction(1, 1) - t.clone()) * c.clone() + t.clone() * d.clone();
            claim(format!("the point of the new curve at t = {t}, which is b({u})"))
                .picture(|| Picture::new().given(points(&b)).found(piece.control_points().to_vec()))
                .equal(piece.at(t), curve.at(u));
        }
    }
}
