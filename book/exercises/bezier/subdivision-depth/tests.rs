use cagd::affine::{Affine, Point};
use cagd::bezier::BezierCurve;
use cagd::bezier::bounds::maximum_norm;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, OrderedScalar, Scalar};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn points(coordinates: &[[i64; 2]]) -> Vec<Point<BigRational, 2>> {
    let point = |xy: &[i64; 2]| Point::new(xy.map(|n| fraction(n, 1)));
    coordinates.iter().map(point).collect()
}

/// The bound 1/4·‖Δ²b‖ is 4, after one halving 1, after two 1/4.
const PARABOLA: [[i64; 2]; 3] = [[0, 0], [5, 8], [10, 0]];

fn probes() -> Vec<String> {
    cagd::probes![
        answer::depth(&points(&PARABOLA), fraction(1, 100)),
        answer::depth(&points(&PARABOLA), fraction(1, 4)),
        answer::depth(&points(&[[0, 0], [0, 4], [4, 4], [4, 0]]), fraction(1, 1)),
        answer::depth(&points(&[[0, 0], [40, 0], [80, 0]]), fraction(1, 1)),
    ]
}

/// The claim that the answer is this number of halvings.
fn compare(b: &[[i64; 2]], tolerance: &BigRational, right: usize) {
    claim("the number of halvings")
        .input(format!("control points {b:?}, ε = {tolerance}"))
        .picture(|| Picture::new().given(points(b)))
        .equal(answer::depth(&points(b), tolerance.clone()), right);
}

/// Why: the bounds 4, 1 and 1/4 can be computed by hand.
#[test]
fn a_parabola() {
    compare(&PARABOLA, &fraction(5, 1), 0);
    compare(&PARABOLA, &fraction(3, 1), 1);
    compare(&PARABOLA, &fraction(1, 2), 2);
    compare(&PARABOLA, &fraction(1, 5), 3);
}

/// Why: equality is allowed, so one more halving is too many.
#[test]
fn the_bound_is_the_tolerance() {
    compare(&PARABOLA, &fraction(4, 1), 0);
    compare(&PARABOLA, &fraction(1, 1), 1);
    compare(&PARABOLA, &fraction(1, 4), 2);
}

/// Why: nothing bends here, however long the legs are.
#[test]
fn straight_lines_and_points() {
    compare(&[[3, 1]], &fraction(1, 1000), 0);
    compare(&[[0, 0], [100, 50]], &fraction(1, 1000), 0);
    compare(
        &[[0, 0], [40, 10], [80, 20], [120, 30]],
        &fraction(1, 1000),
        0,
    );
}

/// Why: the factor is 3/4 for a cubic, and the second difference (4, −4) gives the bound 3.
#[test]
fn a_cubic() {
    let b = [[0, 0], [0, 4], [4, 4], [4, 0]];
    compare(&b, &fraction(3, 1), 0);
    compare(&b, &fraction(1, 1), 1);
    compare(&b, &fraction(1, 100), 5);
}

proptest! {
    /// Why: any degree, and tolerances from large to tiny.
    #[test]
    fn every_curve(
        b in prop::collection::vec(any::<[i8; 2]>(), 1..=6),
        numerator in 1..=200_i64,
        power in 0..=8_u32,
    ) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let tolerance = fraction(numerator, 10_i64.pow(power));
        let curve = BezierCurve::new(points(&b)).expect("at least one point");
        let right = curve.subdivision_depth(&tolerance, maximum_norm).expect("a positive tolerance");
        compare(&b, &tolerance, right);
    }
}

proptest! {
    // Fewer cases, for each looks at up to sixteen pieces.
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Why: it shows what the number is for; after so many halvings every piece is near its chord.
    #[test]
    fn every_piece_is_near_its_chord(
        b in prop::collection::vec(any::<[i8; 2]>(), 1..=4),
        tolerance in 4..=60_i64,
    ) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let tolerance = fraction(tolerance, 1);
        let curve = BezierCurve::new(points(&b)).expect("at least one point");
        // The bound is at most 6/8·512 for these points, so four halvings are enough.
        let halvings = answer::depth(&points(&b), tolerance.clone()).min(4);
        let polygon = curve.corner_cutting().nth(halvings).expect("an endless sequence");
        for piece in polygon.pieces() {
            let piece = BezierCurve::new(piece.to_vec()).expect("control points of a piece");
            for k in 0..=8 {
                let t = fraction(k, 8);
                let chord = piece.at(fraction(0, 1)).lerp(&piece.at(fraction(1, 1)), t.clone());
                let distance = maximum_norm(&(piece.at(t) - chord));
                claim(format!("the distance of a piece from its chord after {halvings} halvings"))
                    .picture(|| Picture::new().given(points(&b)).found(piece.control_points().to_vec()))
                    .holds(distance <= tolerance, format!("at most {tolerance}"), OrderedScalar::to_f64(&distance));
            }
        }
    }
}
