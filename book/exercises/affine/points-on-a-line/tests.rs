use cagd::affine::Point;
use cagd::check::{Picture, Show, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Sum = answer::Sum<BigRational>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn point(xy: [i64; 2]) -> Point<BigRational, 2> {
    Point::new(xy.map(|n| fraction(n, 1)))
}

/// The kind of the sum and its coordinates, in words.
fn words(sum: &Sum) -> String {
    match sum {
        Sum::Point(point) => format!("the point {}", point.show()),
        Sum::Vector(vector) => format!("the vector {}", vector.show()),
        Sum::Nothing => "neither a point nor a vector".to_owned(),
    }
}

fn probes() -> Vec<String> {
    let (a, b) = (point([1, 0]), point([5, 8]));
    let sum = |alpha, beta| words(&answer::weighted_sum(alpha, &a, beta, &b));
    cagd::probes![
        sum(fraction(1, 4), fraction(3, 4)),
        sum(fraction(-3, 1), fraction(3, 1)),
        sum(fraction(1, 1), fraction(1, 1)),
    ]
}

/// The claim that the sum is what its coordinates say, in units of a quarter.
fn compare(alpha: i64, a: [i64; 2], beta: i64, b: [i64; 2]) {
    let quarters = |n: i64| fraction(n, 4);
    // Both kinds of sums may be computed from coordinates: that the origin does not matter is the theorem.
    let coordinates = [0, 1].map(|k| quarters(alpha * a[k] + beta * b[k]));
    let expected = match alpha + beta {
        4 => Sum::Point(Point::new(coordinates)),
        0 => Sum::Vector(coordinates.into()),
        _ => Sum::Nothing,
    };
    let (p, q) = (point(a), point(b));
    let found = answer::weighted_sum(quarters(alpha), &p, quarters(beta), &q);
    claim("what αA + βB is")
        .input(format!(
            "A = {p}, B = {q}, α = {}, β = {}",
            quarters(alpha),
            quarters(beta)
        ))
        .picture(|| {
            let picture = Picture::new().given([p.clone(), q.clone()]);
            let picture = match &expected {
                Sum::Point(right) => picture.expected([right.clone()]),
                _ => picture,
            };
            match &found {
                Sum::Point(point) => picture.found([point.clone()]),
                _ => picture,
            }
        })
        .equal(words(&found), words(&expected));
}

/// The midpoint, three quarters of the way, and the reflection of A in B.
///
/// Why: these are the points that the task asks to draw.
#[test]
fn the_points_of_the_drawing() {
    for (alpha, beta) in [(2, 2), (1, 3), (-4, 8)] {
        compare(alpha, [0, 0], beta, [8, 4]);
        compare(alpha, [3, 3], beta, [3, 3]);
    }
}

/// Why: a coefficient sum of 0 makes a displacement, its length counts, and 0A + 0B is the zero vector.
#[test]
fn coefficients_with_sum_zero() {
    for (alpha, beta) in [(-4, 4), (8, -8), (0, 0)] {
        compare(alpha, [1, 0], beta, [8, 4]);
        compare(alpha, [3, 3], beta, [3, 3]);
    }
}

/// Why: neither 1 nor 0, even where the points coincide.
#[test]
fn coefficients_with_another_sum() {
    for (alpha, beta) in [(4, 4), (2, 0), (-4, 0)] {
        compare(alpha, [1, 0], beta, [8, 4]);
        compare(alpha, [3, 3], beta, [3, 3]);
    }
}

proptest! {
    /// Why: each of the three kinds, with any points.
    #[test]
    fn everywhere(sum in -1..=2_i64, beta in -16..=16_i64, a in any::<[i8; 2]>(), b in any::<[i8; 2]>()) {
        compare(4 * sum - beta, a.map(i64::from), beta, b.map(i64::from));
    }
}
