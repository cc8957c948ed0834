use cagd::affine::{Point, Vector};
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Q = BigRational;
type Polygon = Vec<Point<Q, 2>>;

fn fraction(p: i64, q: i64) -> Q {
    <Q as Scalar>::from_ratio(p, q)
}

fn polygon(coordinates: &[[i64; 2]]) -> Polygon {
    let point = |xy: &[i64; 2]| Point::new(xy.map(|n| fraction(n, 1)));
    coordinates.iter().map(point).collect()
}

fn probes() -> Vec<String> {
    let points = polygon(&[[0, 0], [6, 0], [6, 12], [-6, 18]]);
    let (first, last) = (answer::limit(&points, 0), answer::limit(&points, 3));
    cagd::probes![first.0, first.1, last.0, last.1]
}

/// The sum of points with these weights over `denominator`, coordinate by coordinate.
fn weighted(points: &Polygon, i: usize, weights: [i64; 3], denominator: i64) -> [Q; 2] {
    let n = points.len();
    [0, 1].map(|k| {
        let terms = weights.iter().enumerate();
        terms.fold(fraction(0, 1), |sum, (j, &weight)| {
            sum + fraction(weight, denominator) * &points[(i + n + j - 1) % n][k]
        })
    })
}

fn input(points: &Polygon, i: usize) -> String {
    format!("points {points:?}, i = {i}")
}

fn compare_point(points: &Polygon, i: usize) {
    let limits = |of: &dyn Fn(usize) -> Point<Q, 2>| (0..points.len()).map(of).collect::<Vec<_>>();
    let right = |i: usize| Point::new(weighted(points, i, [1, 4, 1], 6));
    claim("the limit of the vertex")
        .input(input(points, i))
        .picture(|| {
            Picture::new()
                .given(points.clone())
                .expected(limits(&right))
                .found(limits(&|i| answer::limit(points, i).0))
        })
        .equal(answer::limit(points, i).0, right(i));
}

fn compare_derivative(points: &Polygon, i: usize) {
    claim("the derivative at the limit of the vertex")
        .input(input(points, i))
        .equal(
            answer::limit(points, i).1,
            Vector::from(weighted(points, i, [-1, 0, 1], 2)),
        );
}

/// Why: a single point is its own limit, and nothing moves.
#[test]
fn one_vertex() {
    let points = polygon(&[[3, -5]]);
    compare_point(&points, 0);
    compare_derivative(&points, 0);
}

/// Why: the limit is the sixth part of whole numbers here.
#[test]
fn a_square() {
    let points = polygon(&[[0, 0], [6, 0], [6, 6], [0, 6]]);
    compare_point(&points, 1);
}

/// Why: on the points p_j = j the derivative is 1 in the middle.
#[test]
fn equal_steps() {
    compare_derivative(&polygon(&[[0, 0], [1, 0], [2, 0], [3, 0], [4, 0]]), 2);
}

/// The polygon after one step: (1, 6, 1)/8 and the midpoints.
fn refined(points: &Polygon) -> Polygon {
    let pair = |i: usize| {
        [
            weighted(points, i, [1, 6, 1], 8),
            weighted(points, i, [0, 4, 4], 8),
        ]
    };
    (0..points.len()).flat_map(pair).map(Point::new).collect()
}

proptest! {
    /// Why: a step of the scheme moves the vertex but not its limit.
    #[test]
    fn a_step_changes_nothing(p in prop::collection::vec(any::<[i8; 2]>(), 1..7), i in 0_usize..7) {
        let points = polygon(&p.iter().map(|xy| xy.map(i64::from)).collect::<Vec<_>>());
        let i = i % points.len();
        let after = answer::limit(&refined(&points), 2 * i).0;
        claim("the limit before and after a step")
            .input(input(&points, i))
            .equal(answer::limit(&points, i).0, after);
        compare_point(&points, i);
    }

    /// Why: any polygon, also with repeated points.
    #[test]
    fn any_derivative(p in prop::collection::vec(any::<[i8; 2]>(), 1..7), i in 0_usize..7) {
        let points = polygon(&p.iter().map(|xy| xy.map(i64::from)).collect::<Vec<_>>());
        compare_derivative(&points, i % points.len());
    }
}
