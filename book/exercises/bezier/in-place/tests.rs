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

fn probes() -> Vec<String> {
    let cubic = points(&[[0, 0], [3, 9], [12, 6], [9, 0]]);
    cagd::probes![
        answer::evaluate(cubic.clone(), fraction(1, 3)),
        answer::evaluate(cubic, fraction(2, 1)),
        answer::evaluate(points(&[[0, 0], [0, 4], [8, 4]]), fraction(1, 2)),
    ]
}

/// The lower side of the triangle.
fn expected(b: &[RationalPoint], t: &BigRational) -> Vec<RationalPoint> {
    let curve = BezierCurve::new(b.to_vec()).expect("at least one point");
    curve.triangle(t.clone()).right_side().cloned().collect()
}

fn input(b: &[RationalPoint], t: &BigRational) -> String {
    format!("points = {b:?}, t = {t}")
}

/// Why: the claim can be followed with pencil and paper.
#[test]
fn a_parabola() {
    let b = points(&[[0, 0], [0, 4], [8, 4]]);
    let t = fraction(1, 2);
    claim("the list in the end")
        .input(input(&b, &t))
        .equal(answer::evaluate(b.clone(), t.clone()), expected(&b, &t));
}

/// Why: a segment and a single point are the ends of the loops.
#[test]
fn low_degrees() {
    for b in [&[[3, 5]][..], &[[0, 0], [4, 8]]] {
        let (b, t) = (points(b), fraction(1, 4));
        claim("the list in the end")
            .input(input(&b, &t))
            .equal(answer::evaluate(b.clone(), t.clone()), expected(&b, &t));
    }
}

proptest! {
    /// Why: the point itself may be right while the rest of the list is not.
    #[test]
    fn the_point_of_the_curve(b in prop::collection::vec([-4..=4_i64, -4..=4], 1..=6), t in -4..=8_i64) {
        let (b, t) = (points(&b), fraction(t, 4));
        let found = answer::evaluate(b.clone(), t.clone());
        let right = BezierCurve::new(b.clone()).expect("at least one point");
        claim("the first entry in the end, b(t)")
            .picture(|| Picture::new().given(b.clone()).expected([right.at(t.clone())]).found(found.first().cloned()))
            .equal(found.first().cloned(), Some(right.at(t.clone())));
    }

    /// Why: it tries every degree up to 5, and shows the list beside the right one.
    #[test]
    fn the_whole_side(b in prop::collection::vec([-4..=4_i64, -4..=4], 1..=6), t in -4..=8_i64) {
        let (b, t) = (points(&b), fraction(t, 4));
        let found = answer::evaluate(b.clone(), t.clone());
        claim("the list in the end, b₀ⁿ, b₁ⁿ⁻¹, …, bₙ⁰")
            .picture(|| Picture::new().given(b.clone()).expected(expected(&b, &t)).found(found.clone()))
            .equal(found.clone(), expected(&b, &t));
    }
}
