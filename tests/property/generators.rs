//! Random input that likes what is degenerate.
//!
//! Every generator names its classes, and a test counts them: none may stay empty.

use cagd::affine::{Interval, Point};
use cagd::bezier::BezierCurve;
use cagd::law::Sides;
use cagd::scalar::Scalar;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};

use crate::support::Outcome;

/// The highest degree of a random curve.
pub const MAX_DEGREE: usize = 9;

/// How many inputs a law is tried on; `PROPTEST_CASES` overrides it.
const CASES: u32 = 256;

/// Runs a law on random input; the counterexample of a failure is shrunk.
///
/// The seed is fixed, so that a run can be repeated. `CAGD_SEED=<number>` draws other input.
pub fn for_all<S, T>(inputs: S, law: impl Fn(&S::Value) -> Sides<T>) -> Outcome
where
    S: Strategy,
    T: Scalar,
{
    for_all_of(CASES, inputs, law)
}

/// As [`for_all`], on `cases` inputs: fewer where one input is much work.
pub fn for_all_of<S, T>(cases: u32, inputs: S, law: impl Fn(&S::Value) -> Sides<T>) -> Outcome
where
    S: Strategy,
    T: Scalar,
{
    let seed: u64 = match std::env::var("CAGD_SEED") {
        Ok(text) => text.parse().expect("CAGD_SEED must be a whole number"),
        Err(_) => 0,
    };
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let cases = match std::env::var("PROPTEST_CASES") {
        Ok(text) => text.parse().expect("PROPTEST_CASES must be a whole number"),
        Err(_) => cases,
    };
    let config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    TestRunner::new_with_rng(config, rng)
        .run(&inputs, |input| {
            law(&input)
                .judge()
                .map_err(|violation| TestCaseError::fail(violation.to_string()))
        })
        .map_err(|error| match error {
            TestError::Fail(reason, _) => reason.message().to_string(),
            TestError::Abort(reason) => panic!("the generator gives up: {reason}"),
        })
}

/// A number whose size is of the order of `scale`, often a small whole multiple of it.
fn coordinate(scale: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => (-8i32..=8).prop_map(move |k| f64::from(k) * scale),
        3 => (-8.0..8.0).prop_map(move |x: f64| x * scale),
    ]
}

/// Moderate, huge and tiny sizes.
pub fn scale() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => Just(1.0),
        1 => Just(1e150),
        1 => Just(1e-150),
    ]
}

/// A point of the plane.
pub fn point(scale: f64) -> impl Strategy<Value = Point<f64, 2>> {
    [coordinate(scale), coordinate(scale)].prop_map(Point::new)
}

/// Control polygons of degree 0 to [`MAX_DEGREE`]: general, with repeated points, collinear, closed, a single place.
pub fn polygon() -> impl Strategy<Value = Vec<Point<f64, 2>>> {
    (scale(), 0..=MAX_DEGREE).prop_flat_map(|(scale, degree)| {
        let general = || prop::collection::vec(point(scale), degree + 1);
        prop_oneof![
            6 => general(),
            1 => point(scale).prop_map(move |p| vec![p; degree + 1]),
            1 => general().prop_map(|mut points| {
                for i in (1..points.len()).step_by(2) {
                    points[i] = points[i - 1];
                }
                points
            }),
            1 => (point(scale), point(scale), prop::collection::vec(-4i32..=4, degree + 1)).prop_map(
                |(start, end, steps)| {
                    steps
                        .into_iter()
                        .map(|k| start + (end - start) * f64::from(k))
                        .collect()
                }
            ),
            1 => general().prop_map(|mut points| {
                if let Some(last) = points.len().checked_sub(1) {
                    points[last] = points[0];
                }
                points
            }),
        ]
    })
}

/// The unit interval and others, also far away, long and short ones.
pub fn domain() -> impl Strategy<Value = Interval<f64>> {
    prop_oneof![
        3 => Just(Interval::unit()),
        2 => (-8i32..8, 1i32..8).prop_map(|(start, length)| {
            Interval::new(f64::from(start), f64::from(start + length)).expect("a positive length")
        }),
        1 => (-2.0..2.0, 0.001..100.0).prop_map(|(start, length): (f64, f64)| {
            Interval::new(start, start + length).expect("a positive length")
        }),
    ]
}

/// Curves over any domain.
pub fn curve() -> impl Strategy<Value = BezierCurve<Point<f64, 2>>> {
    (domain(), polygon()).prop_map(|(domain, points)| {
        BezierCurve::on(domain, points).expect("finite control points")
    })
}

/// Local parameters: the ends, the middle, inside, close to an end and outside.
pub fn local_parameter() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => Just(0.0),
        1 => Just(1.0),
        1 => Just(0.5),
        5 => 0.0..1.0,
        1 => Just(f64::EPSILON),
        1 => Just(1.0 - f64::EPSILON),
        2 => -1.0..0.0,
        2 => 1.0..2.0,
    ]
}

/// Local parameters in [0, 1].
pub fn inner_parameter() -> impl Strategy<Value = f64> {
    local_parameter().prop_map(|t| t.clamp(0.0, 1.0))
}

/// A curve and a parameter in or around its domain.
pub fn curves_and_parameters() -> impl Strategy<Value = (BezierCurve<Point<f64, 2>>, f64)> {
    (curve(), local_parameter()).prop_map(|(curve, t)| {
        let u = curve.domain().global(t);
        (curve, u)
    })
}

#[test]
fn every_class_of_input_occurs() {
    use std::cell::RefCell;
    use std::collections::BTreeMap;

    let counts = RefCell::new(BTreeMap::new());
    let outcome = for_all(curves_and_parameters(), |(curve, u)| {
        let points = curve.control_points();
        let t = curve.domain().local(*u);
        let size = cagd::affine::Affine::coordinates(&points[0])[0].abs();
        let collinear = points.len() > 2 && points.windows(2).any(|pair| pair[0] != pair[1]) && {
            let origin = points[0];
            let legs: Vec<_> = points.iter().map(|p| *p - origin).collect();
            legs.iter()
                .all(|a| legs.iter().all(|b| a[0] * b[1] == a[1] * b[0]))
        };
        let classes = [
            ("degree 0", curve.degree() == 0),
            ("degree 1", curve.degree() == 1),
            ("highest degree", curve.degree() == MAX_DEGREE),
            (
                "a single place",
                points.len() > 1 && points.iter().all(|p| p == &points[0]),
            ),
            (
                "repeated neighbours",
                points.windows(2).any(|pair| pair[0] == pair[1]),
            ),
            ("collinear", collinear),
            (
                "closed",
                points.len() > 2 && points.first() == points.last(),
            ),
            ("huge", size > 1e149),
            ("tiny", size > 0.0 && size < 1e-148),
            ("another domain", !curve.domain().is_unit()),
            ("at the start", t == 0.0),
            ("at the end", t == 1.0),
            ("before the start", t < 0.0),
            ("after the end", t > 1.0),
        ];
        for (class, occurs) in classes {
            *counts.borrow_mut().entry(class).or_insert(0) += i32::from(occurs);
        }
        Sides::new("statistics").equal("always", [0.0], [0.0], cagd::law::Rounding::none())
    });
    assert_eq!(outcome, Ok(()));
    for (class, count) in counts.into_inner() {
        assert!(count >= 2, "{count} inputs of the class «{class}»");
    }
}
