use cagd::affine::Point;
use cagd::check::{Picture, Show, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Exact = Point<BigRational, 2>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn points(points: &[[i64; 2]]) -> Vec<Exact> {
    points
        .iter()
        .map(|xy| Point::new(xy.map(|n| fraction(n, 1))))
        .collect()
}

fn probes() -> Vec<String> {
    let triangle = [[0, 0], [4, 0], [0, 4]];
    let find =
        |given: &[[i64; 2]], x: [i64; 2]| answer::hull_weights(&points(given), &points(&[x])[0]);
    cagd::probes![
        find(&triangle, [1, 2]),
        find(&triangle, [2, 2]),
        find(&triangle, [3, 3]),
        find(&triangle, [0, 4]),
        find(&[[0, 0], [4, 0], [4, 4], [0, 4]], [1, 2]),
        find(&[[0, 0], [1, 1], [4, 4]], [3, 3]),
        find(&[[0, 0], [1, 1], [4, 4]], [5, 5]),
        find(&[[0, 0], [2, 2], [4, 4], [4, 0]], [2, 1]),
        find(&[[2, 1]], [2, 1]),
        find(&[], [0, 0]),
    ]
}

/// The claim that the answer proves that `x` lies in the hull, or sees that it does not.
fn compare(given: &[[i64; 2]], x: &Exact, is_inside: bool) {
    let given = points(given);
    let shown: Vec<String> = given.iter().map(ToString::to_string).collect();
    let input = format!("points [{}], x = {x}", shown.join(", "));
    let found = answer::hull_weights(&given, x);
    let picture = || Picture::new().given(given.clone()).given([x.clone()]);
    let Some(weights) = &found else {
        claim("whether x lies in the convex hull")
            .input(&input)
            .picture(picture)
            .holds(!is_inside, "weights, since x lies in it", "nothing");
        return;
    };
    claim("whether x lies in the convex hull")
        .input(&input)
        .picture(picture)
        .holds(
            is_inside,
            "nothing, since x does not lie in it",
            found.show(),
        );
    claim("the number of weights")
        .input(&input)
        .equal(weights.len(), given.len());
    claim("the signs of the weights").input(&input).holds(
        weights.iter().all(|weight| *weight >= fraction(0, 1)),
        "no negative weight",
        weights.show(),
    );
    let sum = |terms: &mut dyn Iterator<Item = BigRational>| {
        terms.fold(fraction(0, 1), |sum, term| sum + term)
    };
    claim("the sum of the weights")
        .input(&input)
        .equal(sum(&mut weights.iter().cloned()), fraction(1, 1));
    let coordinate =
        |k: usize| sum(&mut weights.iter().zip(&given).map(|(weight, p)| weight * &p[k]));
    claim("the point that the weights give")
        .input(format!("{input}, weights {}", weights.show()))
        .picture(picture)
        .equal(Point::new([coordinate(0), coordinate(1)]), x.clone());
}

fn at(x: [i64; 2]) -> Exact {
    points(&[x])[0].clone()
}

/// Why: inside, on an edge, at a corner and outside of one triangle.
#[test]
fn a_triangle() {
    let triangle = [[0, 0], [4, 0], [0, 4]];
    for x in [[1, 2], [1, 1], [2, 2], [0, 3], [0, 4]] {
        compare(&triangle, &at(x), true);
    }
    for x in [[3, 3], [-1, 1], [5, 0], [1, -1]] {
        compare(&triangle, &at(x), false);
    }
}

/// Why: no triangle of the first three points contains the point near the fourth corner.
#[test]
fn a_square() {
    let square = [[0, 0], [4, 0], [4, 4], [0, 4]];
    for x in [[1, 3], [3, 3], [2, 2], [1, 2]] {
        compare(&square, &at(x), true);
    }
    compare(&square, &at([5, 2]), false);
}

/// Why: on a line there are no triangles.
#[test]
fn points_on_a_line() {
    let line = [[0, 0], [1, 1], [4, 4], [4, 4]];
    compare(&line, &at([3, 3]), true);
    compare(&line, &at([5, 5]), false);
    compare(&line, &at([2, 3]), false);
    compare(&[[1, 5], [1, 0]], &at([1, 2]), true);
}

/// Why: a triangle whose third point coincides with another is a segment.
#[test]
fn repeated_points() {
    compare(&[[0, 0], [4, 0], [0, 0]], &at([1, 0]), true);
    compare(&[[0, 0], [4, 0], [0, 0]], &at([1, 1]), false);
    compare(&[[0, 0], [0, 0], [4, 0], [0, 4]], &at([1, 1]), true);
}

/// Why: a single point, and none.
#[test]
fn few_points() {
    compare(&[[2, 1]], &at([2, 1]), true);
    compare(&[[2, 1]], &at([2, 2]), false);
    compare(&[[2, 1], [2, 1]], &at([2, 1]), true);
    compare(&[], &at([0, 0]), false);
}

/// Whether x does not lie in the hull: then all points are seen from x within less than half a turn.
///
/// The rightmost of them begins this half turn; every other one is to the left of it, or straight behind it.
fn is_separated(given: &[[i64; 2]], x: [i64; 2]) -> bool {
    let ways: Vec<[i64; 2]> = given.iter().map(|p| [p[0] - x[0], p[1] - x[1]]).collect();
    ways.is_empty()
        || ways.iter().any(|v| {
            let side = |w: &[i64; 2]| (v[0] * w[1] - v[1] * w[0], v[0] * w[0] + v[1] * w[1]);
            ways.iter()
                .map(side)
                .all(|(left, ahead)| left > 0 || (left == 0 && ahead > 0))
        })
}

proptest! {
    /// Why: a planted combination of any points is found to be one.
    #[test]
    fn planted_points(terms in proptest::collection::vec((0..5_i64, [-9..=9_i64, -9..=9_i64]), 1..7)) {
        let total: i64 = terms.iter().map(|(weight, _)| weight).sum();
        prop_assume!(total > 0);
        let given: Vec<[i64; 2]> = terms.iter().map(|(_, p)| *p).collect();
        let coordinate = |k: usize| terms.iter().map(|(weight, p)| weight * p[k]).sum::<i64>();
        let x = Point::new([fraction(coordinate(0), total), fraction(coordinate(1), total)]);
        compare(&given, &x, true);
    }

    /// Why: any points on a small grid; whether all are seen within half a turn decides.
    #[test]
    fn everywhere(given in proptest::collection::vec([-3..=3_i64, -3..=3_i64], 0..6), x in [-3..=3_i64, -3..=3_i64]) {
        compare(&given, &at(x), !is_separated(&given, x));
    }
}
