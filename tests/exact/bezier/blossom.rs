//! Blossoms, proved on full grids for every degree up to 8, and curves over arbitrary intervals up to 12.
//!
//! # Why the grids are enough
//!
//! A function that is affine in each of n arguments is determined by its values on {0, 1}ⁿ: fix all
//! arguments but the first at 0 or 1, then the values at 0 and 1 give those at all first arguments;
//! go on with the second, and so on.
//! In de Casteljau's scheme the argument xⱼ enters step j alone, and a step is affine in it, so the value is affine in
//! each argument. Hence two such functions that agree on the 2ⁿ points of the grid are equal.
//!
//! So the grid proves that the value does not depend on the order: every permutation σ gives again a
//! function that is affine in each argument. It is enough to compare with the sorted arguments, since
//! then all arrangements of the same numbers have the same value.
//! In the same way it proves that the sum of elementary symmetric polynomials is the same function.
//!
//! That one argument is affine is seen in the program, and checked at every point of the grid; by symmetry it is
//! enough to move one argument. Both sides are linear in the control points: unit curves suffice.

use cagd::affine::Interval;
use cagd::bezier::{BezierCurve, BlossomTriangle, laws, power_blossom};
use cagd::scalar::BigRational;
use num_traits::One;

use crate::inputs::{MAX_DEGREE, for_each, integer, interval, unit_curves_on};
use crate::support::jets::jet;
use crate::support::mutants::bezier::blossom as mutants;
use crate::support::{holds, rejects};

type Curve = BezierCurve<BigRational>;
type Polar = fn(&Curve, &[BigRational]) -> BigRational;

/// The highest degree for which blossoms are compared on the full grid.
const MAX_GRID_DEGREE: usize = 8;

fn blossom_value(curve: &Curve, arguments: &[BigRational]) -> BigRational {
    curve.blossom().at(arguments).expect("n arguments")
}

/// All points of {0, 1}ⁿ.
fn grid(degree: usize) -> impl Iterator<Item = Vec<BigRational>> {
    (0..1_u32 << degree).map(move |bits| {
        let digits = (0..degree).map(|k| i64::from(bits >> k & 1));
        digits.map(integer).collect()
    })
}

/// Unit curves over [1, 4] and over [0, 1], with all arguments on the grid.
fn unit_curves_and_arguments() -> impl Iterator<Item = (Curve, Vec<BigRational>)> {
    let domains = [(interval(1, 4), 3), (Interval::unit(), MAX_GRID_DEGREE)];
    domains.into_iter().flat_map(|(domain, max_degree)| {
        (0..=max_degree).flat_map(move |degree| {
            unit_curves_on(domain.clone(), degree)
                .flat_map(move |curve| grid(degree).map(move |point| (curve.clone(), point)))
        })
    })
}

/// Unit curves of every degree up to `max_degree` over [1, 3], each at n + 1 parameters.
fn unit_curves_over_an_interval(max_degree: usize) -> impl Iterator<Item = (Curve, BigRational)> {
    (0..=max_degree).flat_map(|degree| {
        unit_curves_on(interval(1, 3), degree)
            .flat_map(move |curve| (0..=degree as i64).map(move |k| (curve.clone(), integer(k))))
    })
}

/// The diagonal is compared at one value per point of the grid; all n + 1 values 2, …, n + 2 occur, which
/// prove that two polynomials of degree n agree there.
#[test]
fn blossom() {
    let law = |implementation: Polar| {
        for_each(unit_curves_and_arguments(), |(curve, arguments)| {
            let mut order: Vec<usize> = (0..arguments.len()).collect();
            order.sort_by_key(|&k| arguments[k].clone());
            let ones = arguments.iter().filter(|x| x.is_one()).count();
            let other = integer(2 + ones as i64);
            laws::blossom(implementation, curve, arguments, &order, other, integer(-1))
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
        for_each(unit_curves_and_arguments(), |(curve, arguments)| {
            laws::blossom_existence(implementation, curve, arguments)
        })
    };
    holds(law(blossom_value));
    rejects("the first argument", law(mutants::first_argument_only));
    rejects("the mean argument", law(mutants::mean_argument));
    rejects("the mean of the points", law(mutants::mean_of_points));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
}

/// Both sides are affine in each of the four arguments, so the 16 points of the grid prove them equal.
#[test]
fn blossom_exercise() {
    let law = |implementation: fn(usize, &[BigRational]) -> BigRational| {
        for_each(grid(4), |arguments| {
            let arguments: &[BigRational; 4] = arguments.as_slice().try_into().expect("four");
            laws::blossom_exercise(implementation, arguments)
        })
    };
    holds(law(|power, arguments| {
        power_blossom(power, arguments).expect("enough arguments")
    }));
    rejects("not divided", law(mutants::not_divided));
    rejects("n is ignored", law(mutants::degree_ignored));
    rejects("power of the mean", law(mutants::power_of_mean));
}

/// All claims are of degree at most n in u; the new interval is [−1, 3].
#[test]
fn blossom_control_points() {
    let law = |implementation: Polar| {
        for_each(
            unit_curves_over_an_interval(MAX_GRID_DEGREE),
            |(curve, u)| {
                laws::blossom_control_points(implementation, curve, &interval(-1, 3), u.clone())
            },
        )
    };
    holds(law(blossom_value));
    rejects("the first argument", law(mutants::first_argument_only));
    rejects("the mean argument", law(mutants::mean_argument));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
    rejects("t and 1 − t swapped", law(mutants::last_step_reversed));
}

/// Every label is of degree at most n in u.
/// Each side is of degree n in v as well; where u is an end of the domain, one side is no curve.
#[test]
fn blossom_de_casteljau() {
    let inputs = || {
        let curves = unit_curves_over_an_interval(5);
        curves.flat_map(|(curve, u)| {
            let n = curve.degree() as i64;
            (0..=n).map(move |k| (curve.clone(), u.clone(), integer(k)))
        })
    };
    let law = |implementation: fn(&Curve, BigRational) -> BlossomTriangle<BigRational>| {
        for_each(inputs(), |(curve, u, v)| {
            laws::blossom_de_casteljau(implementation, curve, u.clone(), v.clone())
        })
    };
    holds(law(|curve, u| curve.blossom().triangle(u)));
    rejects("mirrored parameter", law(mutants::triangle_reversed));
    rejects("reversed polygon", law(mutants::polygon_reversed));
    rejects(
        "the domain is forgotten",
        law(mutants::triangle_domain_forgotten),
    );
}

#[test]
fn arbitrary_interval() {
    let law = |implementation: fn(&Curve, BigRational) -> (BigRational, Vec<BigRational>)| {
        for_each(unit_curves_over_an_interval(MAX_DEGREE), |(curve, u)| {
            laws::arbitrary_interval(implementation, curve, u.clone())
        })
    };
    holds(law(jet));
    rejects("d/dt for d/du", law(mutants::inner_derivative_forgotten));
    rejects("1/(b − a) once", law(mutants::inner_derivative_once));
    rejects("only shifted", law(mutants::parameter_not_mapped));
}

#[test]
fn segment() {
    let law = |implementation: fn(&Curve, BigRational) -> BigRational| {
        for_each(unit_curves_over_an_interval(MAX_DEGREE), |(curve, u)| {
            laws::segment(implementation, curve, u.clone())
        })
    };
    holds(law(BezierCurve::at));
    rejects("as the slides print it", law(mutants::segment_as_printed));
    rejects("not divided", law(mutants::segment_not_divided));
    rejects("reversed", law(mutants::segment_reversed));
}

/// Polynomials of degree n that agree at n + 1 parameters are equal; and there and back is where one was.
#[test]
fn a_curve_over_another_interval() {
    for degree in 0..=MAX_GRID_DEGREE {
        for curve in unit_curves_on(interval(1, 3), degree) {
            let blossom = curve.blossom();
            let other = blossom.curve_on(interval(-1, 2)).expect("rationals");
            for k in 0..=degree as i64 {
                assert_eq!(other.at(integer(k)), curve.at(integer(k)), "{curve}");
            }
            let back = other.blossom().curve_on(interval(1, 3));
            assert_eq!(back, Ok(curve.clone()));
            let from_blossom = BezierCurve::from_blossom(interval(1, 3), degree, |x| {
                let scheme = blossom.scheme(x).expect("n arguments");
                scheme.tip().clone()
            });
            assert_eq!(from_blossom, Ok(curve));
        }
    }
}
