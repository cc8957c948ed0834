//! Properties of the shape of Bézier curves: ends, images, regions, intersections.

use cagd::affine::{Affine, AffineMap, BoundingBox, Interval, Line, Point, Vector};
use cagd::bezier::{BezierCurve, LineIntersections, laws};
use proptest::prelude::*;

use crate::generators::{
    curve, curves_and_parameters, domain, for_all, inner_parameter, point, polygon,
};
use crate::support::mutants::bezier::shape as mutants;
use crate::support::planted::{Planted, Recipe};
use crate::support::{holds, rejects};

type Point2 = Point<f64, 2>;
type Curve = BezierCurve<Point2>;
type Evaluate = fn(&Curve, f64) -> Point2;

/// A curve and a parameter of its domain, the ends included.
fn inside() -> impl Strategy<Value = (Curve, f64)> {
    (curve(), inner_parameter()).prop_map(|(curve, t)| {
        let domain = curve.domain();
        let u = domain.global(t).clamp(domain.start(), domain.end());
        (curve, u)
    })
}

#[test]
fn end_values() {
    let law = |implementation: Evaluate| {
        for_all(curve(), |curve| laws::end_values(implementation, curve))
    };
    holds(law(BezierCurve::at));
    rejects("t and 1 − t swapped", law(mutants::backwards));
    rejects("the domain is forgotten", law(mutants::domain_forgotten));
    rejects("only the middle half", law(mutants::middle_half));
    rejects(
        "the last point is missing",
        law(mutants::last_point_missing),
    );
}

#[test]
fn endpoint_interpolating() {
    type Scheme = fn(&[Point2], &Interval<f64>, f64) -> Point2;
    let law = |scheme: Scheme| {
        for_all((polygon(), domain()), |(points, domain)| {
            laws::endpoint_interpolating(scheme, points, domain)
        })
    };
    let bezier: Scheme = |points, domain, u| {
        BezierCurve::on(*domain, points.to_vec())
            .expect("a control polygon")
            .at(u)
    };
    holds(law(bezier));
    holds(law(|points, domain, u| {
        cagd::bezier::polygon_at(points, domain.local(u))
    }));
    rejects(
        "through the midpoints of the legs",
        law(mutants::through_midpoints),
    );
    rejects("from the last to the first", law(mutants::last_to_first));
}

#[test]
fn affine_invariance() {
    let entry = || prop_oneof![(-3i32..=3).prop_map(f64::from), -3.0..3.0];
    let maps = [entry(), entry(), entry(), entry(), entry(), entry()]
        .prop_map(|[a, b, c, d, x, y]| AffineMap::new([[a, b], [c, d]], [x, y]));
    let inputs = (curves_and_parameters(), maps);
    let law = |implementation: fn(&Curve, &AffineMap<f64, 2, 2>) -> Curve| {
        for_all(&inputs, |((curve, u), map)| {
            laws::affine_invariance(implementation, curve, map, *u)
        })
    };
    holds(law(|curve, map| curve.mapped(map).expect("finite images")));
    rejects(
        "the translation is forgotten",
        law(mutants::translation_forgotten),
    );
    rejects("only the ends are mapped", law(mutants::ends_mapped_only));
    rejects("the matrix is transposed", law(mutants::matrix_transposed));
}

#[test]
fn symmetry() {
    let law = |implementation: fn(&Curve) -> Curve| {
        for_all(curves_and_parameters(), |(curve, u)| {
            laws::symmetry(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::reversed));
    rejects("not reversed", law(mutants::not_reversed));
    rejects("only the ends are exchanged", law(mutants::ends_exchanged));
    rejects(
        "the domain is forgotten",
        law(mutants::reversed_on_the_unit_interval),
    );
}

#[test]
fn convex_hull() {
    let directions: Vec<Vector<f64, 2>> = (0..16)
        .map(|k| {
            let angle = f64::from(k) * std::f64::consts::TAU / 16.0;
            Vector::from([libm::cos(angle), libm::sin(angle)])
        })
        .collect();
    let law = |implementation: Evaluate| {
        for_all(inside(), |(curve, u)| {
            laws::convex_hull(implementation, curve, *u, &directions)
        })
    };
    holds(law(BezierCurve::at));
    rejects("beyond the ends", law(mutants::beyond_the_ends));
    rejects(
        "without binomial coefficients",
        law(mutants::without_binomials),
    );
    rejects(
        "interpolating the control points",
        law(mutants::interpolating),
    );
}

#[test]
fn bounding_box() {
    let law = |implementation: fn(&Curve) -> BoundingBox<Point2>| {
        for_all(inside(), |(curve, u)| {
            laws::bounding_box(implementation, curve, *u)
        })
    };
    holds(law(BezierCurve::bounding_box));
    rejects("the box of the ends", law(mutants::box_of_the_ends));
    rejects("the box of a few samples", law(mutants::box_of_samples));
    rejects("the origin added", law(mutants::box_with_the_origin));
}

/// The tight box contains the curve, and each of its sides comes near it.
///
/// Outside: the box is made of values of the curve, 3n roundings, and so is the point.
/// Inside: the box is contained in that of the control points.
#[test]
fn tight_bounding_box() {
    use cagd::law::{Rounding, Sides};
    let law = |implementation: fn(&Curve) -> BoundingBox<Point2>| {
        for_all(inside(), |(curve, u)| {
            let largest = |k: usize| {
                curve
                    .control_points()
                    .iter()
                    .map(|p| p[k].abs())
                    .fold(0.0, f64::max)
            };
            let rounding = Rounding::new(6 * curve.degree(), largest(0).max(largest(1)));
            let (tight, coarse, p) = (implementation(curve), curve.bounding_box(), curve.at(*u));
            let list = |point: &Point2| Affine::coordinates(point).to_vec();
            Sides::new(curve)
                .at_most("low", list(tight.low()), list(&p), rounding)
                .at_most("high", list(&p), list(tight.high()), rounding)
                .at_most("inside", list(coarse.low()), list(tight.low()), rounding)
                .at_most("inside", list(tight.high()), list(coarse.high()), rounding)
        })
    };
    holds(law(BezierCurve::tight_bounding_box));
    rejects("the box of the ends", law(mutants::box_of_the_ends));
    rejects("the box of a few samples", law(mutants::box_of_samples));
}

/// Curves with up to six planted intersections, single and multiple, whose numbers are whole.
fn recipes() -> impl Strategy<Value = Recipe> {
    let root = prop_oneof![
        2 => (0i64..=8).prop_map(|k| (k, 8)),
        1 => Just((1, 2)),
        1 => Just((3, 8)),
    ];
    let normal = [-2i64..=2, -2i64..=2].prop_filter("a normal vector", |m| *m != [0, 0]);
    (
        prop::collection::vec(root, 0..=6),
        prop::collection::vec(1i64..=5, 1..=3),
        normal,
        [-5i64..=5, -5i64..=5],
        prop::collection::vec(-50i64..=50, 1..=8),
        prop_oneof![Just([0, 1]), Just([2, 6]), Just([-1, 1])],
    )
        .prop_map(|(roots, factor, normal, foot, along, domain)| Recipe {
            roots,
            factor,
            normal,
            foot,
            along,
            domain,
        })
}

#[test]
fn line_intersections() {
    let law = |implementation: fn(&Curve, &Line<f64>) -> LineIntersections<f64>| {
        for_all(recipes(), |recipe| {
            let Planted {
                curve,
                line,
                intersections,
            } = recipe.build();
            laws::line_intersections(implementation, &curve, &line, &intersections)
        })
    };
    holds(law(|curve, line| {
        curve.line_intersections(line).expect("whole numbers")
    }));
    rejects("the first one only", law(mutants::first_only));
    rejects("sign changes of a few samples", law(mutants::sampled));
    rejects(
        "the polygon for the curve",
        law(mutants::polygon_intersected),
    );
    rejects("always n", law(mutants::always_n));
}

/// A curve that lies in a line is told from one that meets it.
#[test]
fn line_intersections_of_a_curve_in_the_line() {
    let in_a_line =
        (point(1.0), prop::collection::vec(-8i32..=8, 1..=7)).prop_map(|(foot, steps)| {
            // Multiples of 1/8 keep the points exactly on the line.
            let foot = foot.map(|x| (8.0 * x).round() / 8.0);
            let points = steps
                .into_iter()
                .map(|k| foot + Vector::from([2.0, 3.0]) * f64::from(k));
            let curve = BezierCurve::new(points.collect::<Vec<_>>()).expect("a control polygon");
            (
                curve,
                Line::new([3.0, -2.0], 3.0 * foot[0] - 2.0 * foot[1]).expect("a line"),
            )
        });
    let law = |implementation: fn(&Curve, &Line<f64>) -> LineIntersections<f64>| {
        for_all(&in_a_line, |(curve, line)| {
            let found = implementation(curve, line) == LineIntersections::Within;
            cagd::law::Sides::new(curve).equal(
                "the curve lies in the line",
                [f64::from(u8::from(found))],
                [1.0],
                cagd::law::Rounding::none(),
            )
        })
    };
    holds(law(|curve, line| {
        curve.line_intersections(line).expect("small numbers")
    }));
    rejects("sign changes of a few samples", law(mutants::sampled));
}

#[test]
fn variation_diminishing() {
    let lines = (curve(), inner_parameter(), 0.0..std::f64::consts::TAU).prop_filter_map(
        "a finite line",
        |(curve, t, angle)| {
            let normal = [libm::cos(angle), libm::sin(angle)];
            let on_it = curve.at(curve.domain().global(t));
            let line = Line::new(normal, on_it[0] * normal[0] + on_it[1] * normal[1]).ok()?;
            Some((curve, line))
        },
    );
    let law = |implementation: Evaluate| {
        for_all(&lines, |(curve, line)| {
            let domain = curve.domain();
            let parameters: Vec<f64> = (0..=48)
                .map(|k| {
                    domain
                        .global(f64::from(k) / 48.0)
                        .clamp(domain.start(), domain.end())
                })
                .collect();
            laws::variation_diminishing(implementation, curve, line, &parameters)
        })
    };
    holds(law(BezierCurve::at));
    rejects(
        "interpolating the control points",
        law(mutants::interpolating),
    );
    rejects("beyond the ends", law(mutants::beyond_the_ends));
}
