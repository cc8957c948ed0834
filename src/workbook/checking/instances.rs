//! What the tests of exercises have in common, compiled once.
//!
//! This is the library of the package on which answers are compiled, and no module of this crate.
//! Most of a test program are generic functions of the mathematics with the exact numbers that tests are written with.
//! The compiler takes over those that a crate below has compiled already, so this crate calls what many tests call.
//! A test may call anything else as well; it only waits a little longer for it.

#![allow(clippy::all, reason = "it is written to be compiled, not to be called")]

use cagd::affine::{Affine, Point, Vector};
use cagd::bezier::BezierCurve;
use cagd::check::{Picture, Show, claim};
use cagd::scalar::{BigRational, OrderedScalar, Scalar};
use proptest::prelude::*;
use proptest::strategy::ValueTree;

type Number = BigRational;
type P = Point<Number, 2>;
type V = Vector<Number, 2>;

/// Numbers.
pub fn numbers(a: Number, b: Number) -> Vec<String> {
    let fraction = Number::from_ratio(1, 2);
    let results = vec![
        a.clone() + b.clone(),
        a.clone() - b.clone(),
        a.clone() * b.clone(),
        a.clone() / b.clone(),
        -a.clone(),
        &a + &b,
        &a - &b,
        &a * &b,
        &a / &b,
    ];
    let mut sum = Number::from_ratio(0, 1);
    for number in &results {
        sum += number.clone();
        sum -= Number::from_ratio(1, 1);
        sum *= fraction.clone();
    }
    let total: Number = results.iter().cloned().sum();
    let product: Number = results.iter().cloned().product();
    let order = a < b || a <= b || a == b || a != b || a > b || Ord::max(a, b) >= fraction;
    let (less, more) = (sum.to_f64(), total.to_f64());
    vec![format!(
        "{sum} {total:?} {product} {order} {less} {more} {results:?}"
    )]
}

/// Points and vectors.
pub fn points(b: &[[i64; 2]], t: Number) -> Vec<P> {
    let point = |xy: &[i64; 2]| Point::new(xy.map(|n| Number::from_ratio(n, 1)));
    let all: Vec<P> = b.iter().map(point).collect();
    let array: [P; 3] =
        [[0_i64, 1], [2, 3], [4, 5]].map(|xy| Point::new(xy.map(|n| Number::from_ratio(n, 1))));
    let between = array[0].clone() + (array[1].clone() - array[0].clone()) * t.clone();
    let same = Affine::lerp(&array[1], &array[2], t.clone());
    let v: V = array[2].clone() - array[0].clone();
    let w = v.clone() + v.clone() * t.clone() - v.clone();
    let moved = between.clone() - w.clone() + v;
    let (x, y) = (moved[0].clone(), w[1].clone());
    let text = format!("{between} {same:?} {w} {w:?} {all:?} {array:?} {x} {y}");
    let mut sorted = all.clone();
    sorted.reverse();
    sorted.push(moved);
    sorted.extend(array.to_vec());
    sorted.truncate(text.len());
    if all == sorted || array[0] == array[1] || x == y {
        sorted.swap(0, 1);
    }
    sorted
}

/// Curves.
pub fn curves(points: Vec<P>, t: Number) -> Vec<P> {
    let Ok(curve) = BezierCurve::new(points) else {
        return Vec::new();
    };
    let mut found = curve.control_points().to_vec();
    found.push(curve.at(t));
    found.extend(curve.elevated().control_points().iter().cloned());
    found
}

/// Claims.
pub fn claims(points: &[P], t: &Number) -> Vec<String> {
    let number = Number::from_ratio;
    let array: [P; 3] = [(); 3].map(|()| points[0].clone());
    let parameters = || (0..=32).map(|k| number(k, 32));
    let picture = || {
        Picture::new()
            .given(points.to_vec())
            .expected(parameters().map(|t| Point::new([t.clone(), t])))
            .found([points[0].clone()])
            .found(array.clone())
            .given([points[0].clone(), points[1].clone()])
    };
    let (p, q) = (points[0].clone(), points[1].clone());
    claim("a point")
        .input(format!("{p}, {t}"))
        .picture(picture)
        .equal(p.clone(), q.clone());
    claim("points")
        .input(format!("{points:?}"))
        .equal(points.to_vec(), points.to_vec());
    claim("a number").input(t).equal(t.clone(), number(1, 2));
    claim("a vector").equal(p.clone() - q.clone(), q.clone() - p.clone());
    claim("numbers").equal(vec![t.clone()], vec![number(1, 2)]);
    claim(String::new()).input(String::new()).equal(true, false);
    claim("an option").equal(Some(t.clone()), None);
    claim("a count").equal(1_usize, 2);
    claim("a wish").holds(p == q, t, &p);
    claim("a wish").holds(p == q, "so", format!("{p}"));
    let shown = (p.clone(), t.clone()).show();
    let mut probes = cagd::probes![
        p.clone(),
        points.to_vec(),
        t.clone(),
        vec![t.clone()],
        p - q,
        true
    ];
    probes.push(shown);
    probes
}

/// Random input.
pub fn random() {
    fn run<S: Strategy>(strategy: S) {
        let mut runner = proptest::test_runner::TestRunner::default();
        if let Ok(mut tree) = strategy.new_tree(&mut runner) {
            let text = format!("{:?}", tree.current());
            while tree.simplify() && tree.complicate() && !text.is_empty() {}
        }
    }
    run((any::<[i8; 2]>(), any::<i8>(), any::<bool>()));
    run((any::<[[i8; 2]; 3]>(), -8..=8_i64));
    run((any::<[[i8; 2]; 4]>(), 0..8_i64));
    run((prop::collection::vec(any::<[i8; 2]>(), 1..=6), -8..=8_i64));
    run((
        prop::collection::vec([-4..=4_i64, -4..=4], 1..=6),
        0..=4_usize,
        0..4_usize,
    ));
    run(prop::collection::vec(0..5_i64, 3));
}

proptest! {
    #[cold]
    fn a_point_and_a_number(b in any::<[[i8; 2]; 3]>(), t in -8..=16_i64) {
        prop_assert!(b.len() == 3 && t > -20);
    }

    #[cold]
    fn a_polygon(b in prop::collection::vec(any::<[i8; 2]>(), 1..=6)) {
        prop_assert!(b.len() > 1);
    }
}

/// The tests with random input, so that they are compiled.
pub static TESTS: [fn(); 2] = [a_point_and_a_number, a_polygon];
