//! Properties of barycentric coordinates.

use cagd::affine::{AffineBasis, Frame, Point, laws, line_coordinates};
use proptest::prelude::*;

use super::inputs::{place, triangles, weights, whole_triples};
use crate::generators::{for_all, local_parameter};
use crate::support::mutants::affine::barycentric as mutants;
use crate::support::{holds, rejects};

type Point2 = Point<f64, 2>;
type Basis = AffineBasis<f64, 2>;
type Corners = [Point2; 3];

fn basis(triangle: &Corners) -> Basis {
    AffineBasis::new(*triangle).expect("the generator gives no flat triangle")
}

#[test]
fn basis_barycentric_coordinates() {
    let law = |implementation: fn(&Basis, &Point2) -> Vec<f64>| {
        for_all((triangles(), weights(3, 1.0)), |(triangle, weights)| {
            laws::basis_barycentric_coordinates(implementation, &basis(triangle), weights)
        })
    };
    holds(law(Basis::coordinates));
    rejects("order reversed", law(mutants::order_reversed));
    rejects("first weight 0", law(mutants::first_weight_forgotten));
    rejects(
        "first weight too large",
        law(mutants::first_weight_too_large),
    );
}

#[test]
fn frame_equivalence() {
    let law = |implementation: fn(&Basis) -> Frame<f64, 2>| {
        for_all((triangles(), weights(3, 1.0)), |(triangle, weights)| {
            laws::frame_equivalence(implementation, &basis(triangle), weights)
        })
    };
    holds(law(Basis::frame));
    rejects(
        "consecutive differences",
        law(mutants::consecutive_differences),
    );
    rejects("points for vectors", law(mutants::points_for_vectors));
    rejects(
        "the last for the origin",
        law(mutants::last_point_for_origin),
    );
}

#[test]
fn basis_of_differences() {
    let law = |implementation: fn(&Corners) -> bool| {
        for_all(whole_triples(), |points| {
            laws::basis_of_differences(implementation, points)
        })
    };
    holds(law(|points| AffineBasis::new(*points).is_ok()));
    rejects("different points", law(mutants::different_points));
    rejects("as vectors", law(mutants::independent_as_vectors));
}

#[test]
fn barycentric_on_line() {
    type Coordinates = fn(&Point2, &Point2, &Point2) -> Option<[f64; 2]>;
    let different = (place(), place()).prop_filter("A ≠ B", |(a, b)| a != b);
    let law = |implementation: Coordinates| {
        for_all((&different, local_parameter()), |((a, b), t)| {
            laws::barycentric_on_line(implementation, [a, b], t)
        })
    };
    holds(law(|a, b, g| line_coordinates(a, b, g).ok()));
    rejects("the own side", law(mutants::own_side));
    rejects("without signs", law(mutants::unsigned_lengths));
    rejects("inside only", law(mutants::inside_only));
    rejects(
        "a ratio for a coordinate",
        law(mutants::ratio_for_coordinate),
    );
}

#[test]
fn barycentric_in_triangle() {
    type Coordinates = fn(&Corners, &Point2) -> [f64; 3];
    let inputs = (triangles(), weights(3, 1.0)).prop_map(|(triangle, weights)| {
        let g: [f64; 2] =
            std::array::from_fn(|k| (0..3).map(|i| weights[i] * triangle[i][k]).sum());
        (triangle, Point::new(g))
    });
    let law = |implementation: Coordinates| {
        for_all(&inputs, |(triangle, g)| {
            laws::barycentric_in_triangle(implementation, triangle, g)
        })
    };
    let coordinates: Coordinates = |triangle, g| {
        let coordinates = basis(triangle).coordinates(g);
        [coordinates[0], coordinates[1], coordinates[2]]
    };
    holds(law(coordinates));
    rejects("a cyclic shift", law(mutants::next_sides));
    rejects("without signs", law(mutants::unsigned_areas));
    rejects("not divided", law(mutants::not_divided));
}

/// Bad points are refused and named.
#[test]
fn bad_bases_are_named() {
    let [p, q] = [[1.0, 2.0], [3.0, 5.0]].map(Point::new);
    let message = |points: &[Point2]| AffineBasis::new(points.to_vec()).unwrap_err().to_string();
    for points in [[p, q, p], [p, p, p], [p, q, p + (q - p) * 7.0]] {
        let text = message(&points);
        assert!(text.contains("(1, 2), "), "{text}");
        assert!(text.contains("common hyperplane"), "{text}");
    }
    let text = message(&[p, q, Point::new([0.0, f64::NAN])]);
    assert!(
        text.contains("point 2") && text.contains("(0, NaN)"),
        "{text}"
    );
    assert!(message(&[p, q]).contains("needs 3 points, found 2"));
    // Collinear points whose determinant is not 0 in floating point.
    let tenths = [[0.0, 0.0], [0.1, 0.3], [0.7, 2.1]].map(Point::new);
    let by_rounding = cagd::affine::signed_area(&tenths[0], &tenths[1], &tenths[2]);
    assert!(
        by_rounding == 0.0 || AffineBasis::new(tenths).is_err(),
        "{by_rounding:e}"
    );

    let text = line_coordinates(&p, &q, &Point::new([2.0, 2.0]))
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("(2, 2) is not on the line through (1, 2) and (3, 5)"),
        "{text}"
    );
    let text = line_coordinates(&p, &p, &q).unwrap_err().to_string();
    assert!(text.contains("both are (1, 2)"), "{text}");
    let text = line_coordinates(&p, &Point::new([f64::INFINITY, 0.0]), &q)
        .unwrap_err()
        .to_string();
    assert!(text.contains("the point B = (inf, 0)"), "{text}");
}
