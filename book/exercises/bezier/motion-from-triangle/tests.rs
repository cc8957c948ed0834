use cagd::affine::{Interval, Point, Vector};
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Curve = BezierCurve<Point<BigRational, 2>>;

fn number(n: i64) -> BigRational {
    <BigRational as Scalar>::from_integer(n)
}

fn curve(b: &[[i64; 2]], [start, end]: [i64; 2]) -> Curve {
    let domain = Interval::new(number(start), number(end)).expect("start < end");
    let points: Vec<_> = b.iter().map(|xy| Point::new(xy.map(number))).collect();
    BezierCurve::on(domain, points).expect("at least three points")
}

const PARABOLA: [[i64; 2]; 3] = [[0, 0], [2, 4], [4, 0]];
const CUBIC: [[i64; 2]; 4] = [[0, 0], [0, 4], [4, 4], [4, 0]];

fn probes() -> Vec<String> {
    let middle = |[start, end]: [i64; 2]| BigRational::from_ratio(start + end, 2);
    cagd::probes![
        answer::motion(&curve(&CUBIC, [0, 1]), middle([0, 1])),
        answer::motion(&curve(&CUBIC, [2, 4]), middle([2, 4])),
        answer::motion(&curve(&PARABOLA, [0, 3]), number(0)),
    ]
}

/// The claim that the answer gives these two vectors.
fn compare(b: &[[i64; 2]], ends: [i64; 2], u: &BigRational, right: [Vector<BigRational, 2>; 2]) {
    let curve = curve(b, ends);
    let found = || answer::motion(&curve, u.clone());
    claim("velocity and acceleration")
        .input(format!("control points {b:?} over {ends:?}, u = {u}"))
        .picture(|| {
            // The velocity, drawn from the point of the curve.
            let point = || curve.at(u.clone());
            let [expected, _] = right.clone();
            let [velocity, _] = found();
            Picture::new()
                .given(curve.control_points().to_vec())
                .expected([point(), point() + expected])
                .found([point(), point() + velocity])
        })
        .equal(found(), right.clone());
}

fn vectors(coordinates: [[i64; 2]; 2]) -> [Vector<BigRational, 2>; 2] {
    coordinates.map(|xy| Vector::from(xy.map(number)))
}

/// Why: what was right must stay right; (x, y) = (4t, 8t − 8t²).
#[test]
fn a_parabola_over_the_unit_interval() {
    compare(&PARABOLA, [0, 1], &number(0), vectors([[4, 8], [0, -16]]));
    compare(&PARABOLA, [0, 1], &number(1), vectors([[4, -8], [0, -16]]));
}

/// Why: only the degree is new; b′(0) = 3(b₁ − b₀) and b″(0) = 6(b₂ − 2b₁ + b₀).
#[test]
fn a_cubic_over_the_unit_interval() {
    compare(&CUBIC, [0, 1], &number(0), vectors([[0, 12], [24, -24]]));
}

/// Why: only the interval is new; half the velocity, a quarter of the acceleration.
#[test]
fn a_parabola_in_twice_the_time() {
    compare(&PARABOLA, [0, 2], &number(0), vectors([[2, 4], [0, -4]]));
}

/// Why: another start is no reason for another velocity.
#[test]
fn a_parabola_later() {
    compare(&PARABOLA, [5, 6], &number(5), vectors([[4, 8], [0, -16]]));
}

/// Why: nothing accelerates here, so only the velocity can be wrong.
#[test]
fn uniform_motion() {
    let line = [[0, 0], [1, 2], [2, 4], [3, 6]];
    compare(&line, [0, 3], &number(1), vectors([[1, 2], [0, 0]]));
}

proptest! {
    /// Why: any degree from 2, any interval, any parameter.
    #[test]
    fn every_curve(
        b in prop::collection::vec(any::<[i8; 2]>(), 3..=6),
        start in -5..=5_i64,
        length in 1..=5_i64,
        u in -12..=24_i64,
    ) {
        let b: Vec<[i64; 2]> = b.into_iter().map(|xy| xy.map(i64::from)).collect();
        let ends = [start, start + length];
        let u = BigRational::from_ratio(u, 2);
        let right = curve(&b, ends).derivatives(u.clone());
        compare(&b, ends, &u, right);
    }
}
