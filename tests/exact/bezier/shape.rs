//! Ends, images, regions and intersections of Bézier curves over rationals.
//!
//! The identities are proved for every degree up to 12, the inequalities checked at many parameters.

use cagd::affine::{AffineMap, BoundingBox, Interval, Line, Point, Vector};
use cagd::bezier::{BezierCurve, LineIntersections, laws};
use cagd::scalar::BigRational;

use crate::inputs::{
    MAX_DEGREE, at, for_each, integer, interval, ratio, unit_curves_and_parameters,
};
use crate::support::mutants::bezier::shape as mutants;
use crate::support::planted::{Planted, Recipe};
use crate::support::{holds, rejects};

type Exact = BigRational;
type Curve = BezierCurve<Point<Exact, 2>>;
type Evaluate = fn(&Curve, Exact) -> Point<Exact, 2>;

/// Plane polygons of every degree up to 12, over two domains: a zigzag, points on a parabola, points
/// on a line with turning back, and a single place.
fn curves() -> impl Iterator<Item = Curve> {
    let shapes: [fn(i64) -> [i64; 2]; 4] = [
        |i| [i, if i % 2 == 0 { -1 } else { 2 }],
        |i| [i, i * i],
        |i| [i % 3, 2 * (i % 3)],
        |_| [3, -1],
    ];
    [Interval::unit(), interval(2, 5)]
        .into_iter()
        .flat_map(move |domain| {
            (0..=MAX_DEGREE as i64).flat_map(move |degree| {
                let domain = domain.clone();
                shapes.into_iter().map(move |shape| {
                    let points = (0..=degree).map(|i| at(&shape(i)));
                    BezierCurve::on(domain.clone(), points).expect("a control polygon")
                })
            })
        })
}

/// Each curve at the ends of its domain and in between.
fn curves_and_inner_parameters() -> impl Iterator<Item = (Curve, Exact)> {
    curves()
        .flat_map(|curve| (0..=4).map(move |k| (curve.clone(), curve.domain().global(ratio(k, 4)))))
}

#[test]
fn end_values() {
    let law = |implementation: fn(&BezierCurve<Exact>, Exact) -> Exact| {
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, _)| {
            laws::end_values(implementation, curve)
        })
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

/// Both sides are of degree n in t, affine in the control points, and linear in the map.
/// So n + 1 parameters, one control value 1 or none, and the maps x and 1 prove the identity on the line.
/// A coordinate of an image in the plane is a sum of such images.
fn affine_invariance_on_the_line() -> Result<(), String> {
    let maps = [
        AffineMap::new([[integer(1)]], [integer(0)]),
        AffineMap::new([[integer(0)]], [integer(1)]),
    ];
    let inputs = (0..=MAX_DEGREE).flat_map(|degree| {
        (0..=degree + 1).flat_map(move |one| {
            let points = (0..=degree).map(|i| at(&[i64::from(i == one)]));
            let curve: BezierCurve<Point<Exact, 1>> =
                BezierCurve::new(points).expect("a control polygon");
            (0..=degree as i64).map(move |k| (curve.clone(), integer(k)))
        })
    });
    for_each(inputs, |(curve, u)| {
        let law =
            |map: &AffineMap<Exact, 1, 1>| laws::affine_invariance(image, curve, map, u.clone());
        law(&maps[0]).and(law(&maps[1]))
    })
}

fn image<const D: usize>(
    curve: &BezierCurve<Point<Exact, D>>,
    map: &AffineMap<Exact, D, D>,
) -> BezierCurve<Point<Exact, D>> {
    curve.mapped(map).expect("exact numbers are finite")
}

/// On the line for every degree up to 12; in the plane with maps that turn and shear.
#[test]
fn affine_invariance() {
    let maps = [[1, 2, 0, 3, -1, 5], [0, -1, 1, 0, 2, 0], [1, 1, 1, 1, 0, 0]].map(|entries| {
        let [a, b, c, d, x, y] = entries.map(integer);
        AffineMap::new([[a, b], [c, d]], [x, y])
    });
    let law = |implementation: fn(&Curve, &AffineMap<Exact, 2, 2>) -> Curve| {
        for_each(curves_and_inner_parameters().step_by(7), |(curve, u)| {
            let laws = maps
                .each_ref()
                .map(|map| laws::affine_invariance(implementation, curve, map, u.clone()));
            laws.into_iter()
                .reduce(|all, next| all.and(next))
                .expect("there are maps")
        })
    };
    holds(affine_invariance_on_the_line());
    holds(law(image));
    rejects(
        "the translation is forgotten",
        law(mutants::translation_forgotten),
    );
    rejects("only the ends are mapped", law(mutants::ends_mapped_only));
    rejects("the matrix is transposed", law(mutants::matrix_transposed));
}

#[test]
fn symmetry() {
    let law = |implementation: fn(&BezierCurve<Exact>) -> BezierCurve<Exact>| {
        for_each(unit_curves_and_parameters(MAX_DEGREE), |(curve, u)| {
            laws::symmetry(implementation, curve, u.clone())
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

/// Checked, by half-spaces and by the hull itself, flat hulls included.
#[test]
fn convex_hull() {
    let directions: Vec<Vector<Exact, 2>> = [
        [1, 0],
        [0, 1],
        [1, 1],
        [2, -1],
        [-1, 3],
        [-1, -1],
        [0, -1],
        [-1, 0],
    ]
    .map(|[x, y]| Vector::from([integer(x), integer(y)]))
    .into();
    let law = |implementation: Evaluate| {
        for_each(curves_and_inner_parameters(), |(curve, u)| {
            laws::convex_hull(implementation, curve, u.clone(), &directions)
                .and(laws::in_convex_hull(implementation, curve, u.clone()))
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
    rejects(
        "the last point is missing",
        law(mutants::last_point_missing),
    );
}

/// Checked at the ends of the domain and in between.
#[test]
fn bounding_box() {
    let law = |implementation: fn(&Curve) -> BoundingBox<Point<Exact, 2>>| {
        for_each(curves_and_inner_parameters(), |(curve, u)| {
            laws::bounding_box(implementation, curve, u.clone())
        })
    };
    holds(law(BezierCurve::bounding_box));
    rejects("the box of the ends", law(mutants::box_of_the_ends));
    rejects("the box of a few samples", law(mutants::box_of_samples));
    rejects("the origin added", law(mutants::box_with_the_origin));
}

/// Planted intersections of every degree up to 12: single, double, triple, at the ends, none at all.
fn recipes() -> impl Iterator<Item = Recipe> {
    let pool = [
        (1, 2),
        (0, 1),
        (1, 3),
        (1, 3),
        (1, 1),
        (3, 4),
        (2, 3),
        (1, 2),
        (1, 2),
        (1, 4),
        (3, 4),
        (0, 1),
    ];
    (0..=MAX_DEGREE)
        .map(move |degree| Recipe {
            roots: pool[..degree].to_vec(),
            factor: vec![1],
            normal: [1, -2],
            foot: [degree as i64, 3],
            along: vec![0, 3, 1, -2, 5],
            domain: [[0, 1], [2, 5]][degree % 2],
        })
        .chain((0..=3).map(move |roots| Recipe {
            roots: pool[..roots].to_vec(),
            factor: vec![1, 5, 2, 1],
            normal: [0, 1],
            foot: [0, 0],
            along: vec![0, 1],
            domain: [0, 1],
        }))
}

#[test]
fn line_intersections() {
    let law = |implementation: fn(&Curve, &Line<Exact>) -> LineIntersections<Exact>| {
        for_each(recipes(), |recipe| {
            let Planted {
                curve,
                line,
                intersections,
            } = recipe.build();
            laws::line_intersections(implementation, &curve, &line, &intersections)
        })
    };
    holds(law(|curve, line| {
        curve
            .line_intersections(line)
            .expect("exact numbers are finite")
    }));
    rejects("the first one only", law(mutants::first_only));
    rejects("sign changes of a few samples", law(mutants::sampled));
    rejects(
        "the polygon for the curve",
        law(mutants::polygon_intersected),
    );
    rejects("always n", law(mutants::always_n));
}

/// Checked for lines through pairs of control points and between them, and for convex polygons.
#[test]
fn variation_diminishing() {
    let lines = [
        ([0, 1], ratio(1, 2)),
        ([1, 2], ratio(4, 1)),
        ([1, 3], ratio(7, 2)),
        ([-1, 1], integer(0)),
    ];
    let law = |implementation: Evaluate| {
        for_each(curves().filter(|curve| curve.domain().is_unit()), |curve| {
            let domain = curve.domain();
            let parameters: Vec<Exact> = (0..=8).map(|k| domain.global(ratio(k, 8))).collect();
            let crossings = lines.iter().map(|(normal, offset)| {
                let line = Line::new(normal.map(integer), offset.clone()).expect("a line");
                laws::variation_diminishing(implementation, curve, &line, &parameters)
            });
            crossings
                .reduce(|all, next| all.and(next))
                .expect("there are lines")
                .and(laws::convex_polygon_convex_curve(
                    implementation,
                    curve,
                    &parameters[1..7],
                ))
        })
    };
    holds(law(BezierCurve::at));
    rejects(
        "interpolating the control points",
        law(mutants::interpolating),
    );
    rejects("beyond the ends", law(mutants::beyond_the_ends));
}
