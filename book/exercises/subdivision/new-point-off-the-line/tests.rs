use cagd::affine::Point;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Points = [Point<BigRational, 2>; 4];

fn fraction(p: i64, q: i64) -> BigRational {
    <BigRational as Scalar>::from_ratio(p, q)
}

fn points(coordinates: [[i64; 2]; 4]) -> Points {
    coordinates.map(|xy| Point::new(xy.map(|n| fraction(n, 1))))
}

fn probes() -> Vec<String> {
    let p = points([[0, 3], [2, 6], [10, 4], [11, -5]]);
    cagd::probes![
        answer::new_point(&p, fraction(0, 1)),
        answer::new_point(&p, fraction(1, 16)),
        answer::new_point(&p, fraction(1, 4)),
    ]
}

/// The midpoint of the inner points, moved by w times its distance from the midpoint of the outer ones, doubled.
fn expected(p: &Points, w: &BigRational) -> Point<BigRational, 2> {
    let coordinate = |k: usize| {
        let inner = (&p[1][k] + &p[2][k]) / fraction(2, 1);
        let outer = (&p[0][k] + &p[3][k]) / fraction(2, 1);
        &inner + fraction(2, 1) * w * (&inner - outer)
    };
    Point::new([coordinate(0), coordinate(1)])
}

fn compare(p: &Points, w: &BigRational) {
    claim("the new point")
        .input(format!(
            "p = {}, {}, {}, {}, w = {w}",
            p[0], p[1], p[2], p[3]
        ))
        .picture(|| {
            Picture::new()
                .given(p.clone())
                .expected([p[1].clone(), expected(p, w), p[2].clone()])
                .found([p[1].clone(), answer::new_point(p, w.clone()), p[2].clone()])
        })
        .equal(answer::new_point(p, w.clone()), expected(p, w));
}

/// Why: four equal points are the smallest input that shows weights of another sum than 1.
#[test]
fn one_place() {
    compare(&points([[1, 2]; 4]), &fraction(1, 16));
}

/// Why: without tension the curve is the polygon.
#[test]
fn midpoints() {
    compare(&points([[0, 0], [2, 0], [4, 6], [5, 5]]), &fraction(0, 1));
}

/// Why: the inner points decide alone if the outer ones are at the origin.
#[test]
fn around_the_origin() {
    compare(&points([[0, 0], [1, 0], [0, 1], [0, 0]]), &fraction(1, 16));
}

proptest! {
    /// Why: any points and tensions, so that weights of sum 1 alone do not pass.
    #[test]
    fn any_points(p in any::<[[i8; 2]; 4]>(), w in -16_i64..=16) {
        compare(&points(p.map(|xy| xy.map(i64::from))), &fraction(w, 32));
    }
}
