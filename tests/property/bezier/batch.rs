//! Batches agree with exact arithmetic within the stated bound.

use cagd::affine::Point;
use cagd::bezier::BezierCurve;
use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, OrderedScalar, exact};
use proptest::prelude::*;

use crate::generators::{for_all, inner_parameter, local_parameter, polygon};
use crate::support::{holds, rejects};

type Curve = BezierCurve<Point<f64, 2>>;
type Batch = fn(&Curve, &[f64]) -> Vec<Point<f64, 2>>;

fn interleaved(curve: &Curve, parameters: &[f64]) -> Vec<Point<f64, 2>> {
    let mut points = vec![Point::origin(); parameters.len()];
    curve
        .evaluate_into(parameters, &mut points)
        .expect("equal lengths");
    points
}

fn split(curve: &Curve, parameters: &[f64]) -> Vec<Point<f64, 2>> {
    let mut x = vec![0.0; parameters.len()];
    let mut y = x.clone();
    curve
        .evaluate_split_into(parameters, [&mut x, &mut y])
        .expect("equal lengths");
    x.into_iter()
        .zip(y)
        .map(|(x, y)| Point::new([x, y]))
        .collect()
}

/// The distance to the exact point in units of u·max|bᵢ|·(|t| + |1 − t|)ⁿ, rounded up.
fn errors(curve: &Curve, parameters: &[f64], points: &[Point<f64, 2>]) -> Vec<f64> {
    let rational = |x: f64| exact(x).expect("a finite number");
    let exact_points = curve
        .control_points()
        .iter()
        .map(|point| point.map(rational));
    let exact_curve = BezierCurve::new(exact_points).expect("finite control points");
    let largest = curve
        .control_points()
        .iter()
        .flat_map(|point| [point[0], point[1]]);
    let largest = largest.fold(0.0, |a: f64, x| a.max(x.abs()));
    let units = parameters.iter().zip(points).flat_map(|(&t, point)| {
        let expected = exact_curve.at(rational(t));
        let growth = (t.abs() + (1.0 - t).abs()).powi(curve.degree() as i32);
        let unit = rational(cagd::scalar::UNIT_ROUNDOFF * growth) * rational(largest);
        [0, 1].map(|d| {
            let error: BigRational =
                OrderedScalar::abs(&(rational(point[d]) - expected[d].clone()));
            if largest == 0.0 {
                error.to_f64()
            } else {
                (error / unit.clone()).to_f64()
            }
        })
    });
    units.collect()
}

/// A batch is as exact as its documentation says: (3n + 6) units.
///
/// Sizes whose products underflow are left out; there the bound has the smallest normal number added.
#[test]
fn batch() {
    let inputs = || {
        let parameters = prop::collection::vec(local_parameter(), 1..20);
        let polygons = polygon().prop_filter("no underflow", |points| {
            points.iter().all(|point| {
                [0, 1]
                    .iter()
                    .all(|&d| point[d] == 0.0 || point[d].abs() > 1e-100)
            })
        });
        (polygons, parameters)
    };
    let law = |batch: Batch| {
        for_all(inputs(), |(points, parameters)| {
            let curve = BezierCurve::new(points.clone()).expect("finite control points");
            let found = batch(&curve, parameters);
            let bound = 3.0 * curve.degree() as f64 + 6.0;
            let errors = errors(&curve, parameters, &found);
            let bounds = vec![bound; 2 * parameters.len()];
            Sides::new(format!("parameters {parameters:?}, {curve}")).at_most(
                "the error is at most 3n + 6 units",
                errors,
                bounds,
                Rounding::none(),
            )
        })
    };
    holds(law(interleaved));
    holds(law(split));
    rejects(
        "the last block is forgotten",
        law(|curve, parameters| {
            let mut points = interleaved(curve, parameters);
            let rest = parameters.len() % 8;
            let full = points.len() - rest;
            points[full..].fill(Point::origin());
            points
        }),
    );
    rejects(
        "t and 1 − t swapped",
        law(|curve, parameters| {
            let swapped: Vec<f64> = parameters.iter().map(|t| 1.0 - t).collect();
            interleaved(curve, &swapped)
        }),
    );
}

/// Degree 10 in [0, 1]: at most 10 units in the last place of the size of the control polygon, which
/// is at least 2u times that size, so 10 such places are at least 20 units of u.
#[test]
fn degree_ten_is_accurate() {
    let law = |batch: Batch| {
        let coordinates = || [-1.0..1.0, -1.0..1.0].prop_map(Point::new);
        let polygons = prop::collection::vec(coordinates(), 11);
        let parameters = prop::collection::vec(inner_parameter(), 1..10);
        for_all((polygons, parameters), |(points, parameters)| {
            let curve = BezierCurve::new(points.clone()).expect("finite control points");
            let errors = errors(&curve, parameters, &batch(&curve, parameters));
            let bounds = vec![20.0; errors.len()];
            Sides::new(format!("parameters {parameters:?}, {curve}")).at_most(
                "the error is at most 10 ulp",
                errors,
                bounds,
                Rounding::none(),
            )
        })
    };
    holds(law(interleaved));
    rejects(
        "single precision",
        law(|curve, parameters| {
            let points = interleaved(curve, parameters);
            points
                .iter()
                .map(|point| point.map(|x| f64::from(x as f32)))
                .collect()
        }),
    );
}

/// Both kinds of output hold the same numbers, bit for bit.
#[test]
fn split_arrays() {
    let law = |batch: Batch| {
        let parameters = prop::collection::vec(local_parameter(), 1..40);
        for_all((polygon(), parameters), |(points, parameters)| {
            let curve = BezierCurve::new(points.clone()).expect("finite control points");
            let coordinates = |batch: Batch| {
                batch(&curve, parameters)
                    .into_iter()
                    .flat_map(|point| [point[0], point[1]])
            };
            Sides::new(format!("parameters {parameters:?}, {curve}")).equal(
                "split arrays hold the interleaved coordinates",
                coordinates(batch),
                coordinates(interleaved),
                Rounding::none(),
            )
        })
    };
    holds(law(split));
    rejects(
        "x and y swapped",
        law(|curve, parameters| {
            let points = split(curve, parameters).into_iter();
            points
                .map(|point| Point::new([point[1], point[0]]))
                .collect()
        }),
    );
}

#[test]
fn a_batch_on_another_domain_maps_its_parameters() {
    let domain = cagd::affine::Interval::new(2.0, 6.0).expect("a positive length");
    let points = [[0.0, 0.0], [1.0, 4.0], [2.0, 0.0]].map(Point::new);
    let curve = BezierCurve::on(domain, points).expect("finite control points");
    let found = interleaved(&curve, &[2.0, 4.0, 6.0]);
    assert_eq!(found, [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]].map(Point::new));
}

#[test]
fn lengths_that_differ_are_an_error() {
    let curve = BezierCurve::new([Point::new([0.0, 1.0])]).expect("a finite point");
    let mut points = [Point::origin(); 2];
    let error = curve
        .evaluate_into(&[0.0, 0.5, 1.0], &mut points)
        .unwrap_err();
    assert_eq!((error.parameters, error.room), (3, 2));
    assert_eq!(points, [Point::origin(); 2], "nothing is written");
}
