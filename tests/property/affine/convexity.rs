//! Properties of convex sets and of polygons.

use cagd::affine::{Affine, ConvexHull, Location, Point, SimplePolygon, laws};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{MAX_DEGREE, for_all, polygon};
use crate::support::mutants::affine::convexity as mutants;
use crate::support::{holds, rejects};

type Place = Point<f64, 2>;

/// Points with weights, none negative, not all 0.
fn weighted_points() -> impl Strategy<Value = (Vec<Place>, Vec<f64>)> {
    let weight = prop_oneof![1 => Just(0.0), 3 => 0.0..1.0];
    let weights = prop::collection::vec(weight, MAX_DEGREE + 1);
    (polygon(), weights).prop_map(|(points, mut weights)| {
        weights.truncate(points.len());
        weights[0] += 0.5;
        (points, weights)
    })
}

#[test]
fn convex_set_and_hull() {
    let law = |implementation: fn(&[Place]) -> Vec<Place>| {
        for_all(weighted_points(), |(points, weights)| {
            laws::convex_set_and_hull(implementation, points, weights)
        })
    };
    holds(law(mutants::hull));
    rejects("the corners of the box", law(mutants::corners_of_the_box));
    rejects("one point left out", law(mutants::last_point_missing));
    rejects("the points as they are", law(mutants::as_given));
    rejects("clockwise", law(mutants::clockwise));
}

/// For a convex polygon, winding numbers and half-planes say the same of each point; the segment between two points
/// of a hull has no part outside.
#[test]
fn locations_in_a_convex_polygon() {
    type Locate = fn(&SimplePolygon<f64>, &Place) -> bool;
    let inputs =
        (polygon(), polygon()).prop_filter_map("a hull with an inside", |(set, probes)| {
            let hull = ConvexHull::of(&set).ok()?;
            let polygon = SimplePolygon::new(hull.vertices().iter().copied()).ok()?;
            Some((hull, polygon, probes))
        });
    let law = |contains: Locate| {
        for_all(&inputs, |(hull, polygon, probes)| {
            let vertices = polygon.vertices();
            let middle = vertices[0].lerp(&vertices[1], 0.5);
            let probes = || probes.iter().chain(vertices).chain([&middle]);
            let number = |inside: bool| f64::from(u8::from(inside));
            Sides::new(format!("{polygon:?}"))
                .equal(
                    "polygon and hull contain the same points",
                    probes().map(|probe| number(contains(polygon, probe))),
                    probes().map(|probe| number(hull.contains(probe))),
                    Rounding::none(),
                )
                .equal(
                    "the polygon is convex",
                    [number(polygon.is_convex())],
                    [1.0],
                    Rounding::none(),
                )
        })
    };
    holds(law(SimplePolygon::contains));
    rejects(
        "without the boundary",
        law(|polygon, point| polygon.locate(point) == Location::Inside),
    );
}
