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

fn probes() -> Vec<String> {
    let cubic = points(&[[0, 0], [0, 9], [9, 9], [9, 0]]);
    cagd::probes![
        answer::subdivided(&cubic, fraction(1, 3)),
        answer::subdivided(&points(&[[0, 0], [2, 0]]), fraction(1, 2)),
    ]
}

/// The claim that the answer gives these two polygons.
fn compare(b: &[[i64; 2]], alpha: &BigRational, right: [Points; 2]) {
    let found = || answer::subdivided(&points(b), alpha.clone());
    claim("the control polygons of the left and the right piece")
        .input(format!("control points {b:?}, α = {alpha}"))
        .picture(|| {
            let [left, rest] = right.clone();
            let [found_left, found_rest] = found();
            Picture::new()
                .given(points(b))
                .expected(left)
                .expected(rest)
                .found(found_left)
                .found(found_rest)
        })
        .equal(found(), right.clone());
}

/// Why: halves of a parabola can be drawn by hand.
#[test]
fn a_parabola_halved() {
    compare(
        &[[0, 0], [4, 8], [8, 0]],
        &fraction(1, 2),
        [
            points(&[[0, 0], [2, 4], [4, 4]]),
            points(&[[4, 4], [6, 4], [8, 0]]),
        ],
    );
}

/// Why: all points of the triangle are different, so no index can be mistaken.
#[test]
fn a_cubic_at_a_third() {
    compare(
        &[[0, 0], [0, 27], [27, 27], [27, 0]],
        &fraction(1, 3),
        [
            points(&[[0, 0], [0, 9], [3, 15], [7, 18]]),
            points(&[[7, 18], [15, 24], [27, 18], [27, 0]]),
        ],
    );
}

/// Why: a curve of degree 0 is in both pieces.
#[test]
fn a_point() {
    compare(
        &[[3, 1]],
        &fraction(1, 4),
        [points(&[[3, 1]]), points(&[[3, 1]])],
    );
}

/// Why: at the ends of the interval one piece is a point.
#[test]
fn at_the_ends() {
    let b = [[0, 0], [2, 4], [6, 4]];
    compare(&b, &fraction(0, 1), [points(&[[0, 0]; 3]), points(&b)]);
    compare(&b, &fraction(1, 1), [points(&b), points(&[[6, 4]; 3])]);
}

proptest! {
    // Fewer cases, for each compares two polynomials.
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Why: it compares the motion of the pieces with that of the curve, and not the points.
    #[test]
    fn the_pieces_make_up_the_curve(
        b in prop::collection::vec(any::<[i8; 2]>(), 1..=6),
        alpha in -4..=12_i64,
    ) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let alpha = fraction(alpha, 8);
        let curve = BezierCurve::new(points(&b)).expect("at least one point");
        let found = answer::subdivided(&points(&b), alpha.clone());
        claim("the numbers of control points").equal(found.each_ref().map(Vec::len), [b.len(); 2]);
        let [left, right] = found.map(|piece| BezierCurve::new(piece).expect("at least one point"));
        // Polynomials of degree n that agree at n + 1 parameters are equal.
        for k in 0..b.len() as i64 {
            let t = fraction(k, 3);
            let on_the_right = (fraction(1, 1) - alpha.clone()) * t.clone() + alpha.clone();
            claim(format!("the points of both pieces at t = {t}"))
                .picture(|| {
                    Picture::new()
                        .given(points(&b))
                        .found(left.control_points().to_vec())
                        .found(right.control_points().to_vec())
                })
                .equal(
                    (left.at(t.clone()), right.at(t.clone())),
                    (curve.at(alpha.clone() * t), curve.at(on_the_right)),
                );
        }
    }
}
