//! Properties of blossoms and of curves over arbitrary intervals.

use cagd::affine::{Interval, Point, Vector};
use cagd::bezier::{BezierCurve, laws};
use proptest::prelude::*;

use crate::generators::{MAX_DEGREE, curve, curves_and_parameters, for_all, local_parameter};
use crate::support::jets::jet;
use crate::support::mutants::bezier::blossom as mutants;
use crate::support::{holds, rejects};

type Point2 = Point<f64, 2>;
type Curve = BezierCurve<Point2>;
type Jet = fn(&Curve, f64) -> (Point2, Vec<Vector<f64, 2>>);
type Polar = fn(&Curve, &[f64]) -> Point2;

fn blossom_value(curve: &Curve, arguments: &[f64]) -> Point2 {
    let value = curve.blossom().at(arguments);
    value.expect("n finite arguments and a finite value")
}

/// A curve and as many arguments, in and around its domain, as its degree says.
fn curves_and_arguments() -> impl Strategy<Value = (Curve, Vec<f64>)> {
    let arguments = prop::collection::vec(local_parameter(), MAX_DEGREE);
    (curve(), arguments).prop_map(|(curve, mut arguments)| {
        arguments.truncate(curve.degree());
        for argument in &mut arguments {
            *argument = curve.domain().global(*argument);
        }
        (curve, arguments)
    })
}

#[test]
fn blossom() {
    let inputs = || {
        let curves = curves_and_arguments().prop_flat_map(|(curve, arguments)| {
            let indices: Vec<usize> = (0..arguments.len()).collect();
            (Just(curve), Just(arguments), Just(indices).prop_shuffle())
        });
        (curves, local_parameter(), local_parameter())
    };
    let law = |implementation: Polar| {
        for_all(inputs(), |((curve, arguments, order), other, lambda)| {
            let other = curve.domain().global(*other);
            laws::blossom(implementation, curve, arguments, order, other, *lambda)
        })
    };
    holds(law(blossom_value));
    rejects("the first argument", law(mutants::first_argument_only));
    rejects("the mean argument", law(mutants::mean_argument));
    rejects("the mean of the points", law(mutants::mean_of_points));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
    rejects("t and 1 − t swapped", law(mutants::last_step_reversed));
}

#[test]
fn blossom_existence() {
    let law = |implementation: Polar| {
        for_all(curves_and_arguments(), |(curve, arguments)| {
            laws::blossom_existence(implementation, curve, arguments)
        })
    };
    holds(law(blossom_value));
    rejects("the first argument", law(mutants::first_argument_only));
    rejects("the mean argument", law(mutants::mean_argument));
    rejects("the mean of the points", law(mutants::mean_of_points));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
}

#[test]
fn blossom_control_points() {
    let ends = || {
        (local_parameter(), local_parameter()).prop_filter("two ends", |(start, end)| start != end)
    };
    let law = |implementation: Polar| {
        for_all((curves_and_parameters(), ends()), |((curve, u), ends)| {
            let domain = curve.domain();
            // Ends that differ by a single rounding may become equal in the domain.
            let interval =
                Interval::new(domain.global(ends.0), domain.global(ends.1)).unwrap_or(*domain);
            laws::blossom_control_points(implementation, curve, &interval, *u)
        })
    };
    holds(law(blossom_value));
    rejects("the first argument", law(mutants::first_argument_only));
    rejects("the mean argument", law(mutants::mean_argument));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
    rejects("t and 1 − t swapped", law(mutants::last_step_reversed));
}

#[test]
fn arbitrary_interval() {
    let law = |implementation: Jet| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::arbitrary_interval(implementation, curve, *u)
        })
    };
    holds(law(jet));
    rejects("d/dt for d/du", law(mutants::inner_derivative_forgotten));
    rejects("1/(b − a) once", law(mutants::inner_derivative_once));
    rejects("only shifted", law(mutants::parameter_not_mapped));
}

#[test]
fn segment() {
    let law = |implementation: fn(&Curve, f64) -> Point2| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::segment(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::at));
    rejects("as the slides print it", law(mutants::segment_as_printed));
    rejects("not divided", law(mutants::segment_not_divided));
    rejects("reversed", law(mutants::segment_reversed));
}
