//! Weighted points, bases and what else the laws of the chapter are tried on.

use cagd::affine::{AffineBasis, Point, Vector};
use cagd::law::Sides;
use proptest::prelude::*;

use crate::generators::{for_all, point, polygon, scale};

/// Weighted points of the plane.
pub type Terms = Vec<(f64, Point<f64, 2>)>;

/// A multiple of 1/8 of at most 2 in absolute value.
///
/// Sums and products of some of them are free of rounding.
pub fn eighth() -> impl Strategy<Value = f64> {
    (-16i32..=16).prop_map(|k| f64::from(k) / 8.0)
}

/// Weights in eighths with this sum; in one of three cases none is negative.
pub fn weights(count: usize, sum: f64) -> impl Strategy<Value = Vec<f64>> {
    let signed = prop::collection::vec(eighth(), count).prop_map(move |mut weights| {
        let others: f64 = weights[1..].iter().sum();
        weights[0] = sum - others;
        weights
    });
    // Cuts of [0, sum], which may coincide, so that weights are 0.
    let eighths = (sum * 8.0) as i32;
    let positive =
        prop::collection::vec(0..=eighths.max(0), count - 1).prop_map(move |mut cuts| {
            cuts.sort_unstable();
            let ends = cuts.iter().copied().chain([eighths]);
            let starts = std::iter::once(0).chain(cuts.iter().copied());
            std::iter::zip(starts, ends)
                .map(|(start, end)| f64::from(end - start) / 8.0)
                .collect()
        });
    prop_oneof![2 => signed, 1 => positive]
}

/// Up to ten points, also repeated, collinear, huge and tiny ones, with weights of this sum.
pub fn terms(sum: impl Strategy<Value = f64>) -> impl Strategy<Value = Terms> {
    (polygon(), sum).prop_flat_map(|(points, sum)| {
        weights(points.len(), sum)
            .prop_map(move |weights| std::iter::zip(weights, points.clone()).collect())
    })
}

/// 1, 0 or another sum of weights.
pub fn any_sum() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(1.0), 1 => Just(0.0), 1 => eighth()]
}

/// A vector, also a huge, a tiny one and 0.
pub fn vector() -> impl Strategy<Value = Vector<f64, 2>> {
    prop_oneof![
        6 => scale().prop_flat_map(point).prop_map(|tip| tip.from_origin()),
        1 => Just(Vector::zeros()),
    ]
}

/// A point, also a huge and a tiny one.
pub fn place() -> impl Strategy<Value = Point<f64, 2>> {
    scale().prop_flat_map(point)
}

/// Three points with whole coordinates, also repeated and collinear ones.
pub fn whole_triples() -> impl Strategy<Value = [Point<f64, 2>; 3]> {
    let whole = || [-8i32..=8, -8i32..=8].prop_map(|p| Point::new(p.map(f64::from)));
    let general = || [whole(), whole(), whole()];
    prop_oneof![
        4 => general(),
        1 => (general(), 0..3usize, 0..3usize).prop_map(|(mut points, i, j)| {
            points[i] = points[j];
            points
        }),
        2 => (whole(), whole(), -3i32..=3).prop_map(|(a, b, k)| [a, b, a + (b - a) * f64::from(k)]),
    ]
}

/// Triangles that are not flat, thin ones too, moderate, huge and tiny.
pub fn triangles() -> impl Strategy<Value = [Point<f64, 2>; 3]> {
    (whole_triples(), scale())
        .prop_filter("not collinear", |(points, _)| {
            AffineBasis::new(*points).is_ok()
        })
        .prop_map(|(points, scale)| points.map(|point| point.map(|x| x * scale)))
}

#[test]
fn every_class_of_input_occurs() {
    use std::cell::RefCell;
    use std::collections::BTreeMap;

    let counts = RefCell::new(BTreeMap::new());
    let inputs = (terms(any_sum()), triangles(), whole_triples());
    let outcome = for_all(inputs, |(terms, triangle, triple)| {
        let sum: f64 = terms.iter().map(|(weight, _)| weight).sum();
        let negative = terms.iter().any(|(weight, _)| *weight < 0.0);
        let size = triangle.iter().map(|p| p[0].abs()).fold(0.0, f64::max);
        let [a, b, c] = triple;
        let classes = [
            ("one term", terms.len() == 1),
            ("affine, not convex", sum == 1.0 && negative),
            ("convex", sum == 1.0 && !negative),
            ("a vector", sum == 0.0),
            ("neither", sum != 0.0 && sum != 1.0),
            ("a weight 0", terms.iter().any(|(weight, _)| *weight == 0.0)),
            (
                "repeated points",
                terms.windows(2).any(|pair| pair[0].1 == pair[1].1),
            ),
            ("huge triangle", size > 1e149),
            ("tiny triangle", size < 1e-148),
            (
                "clockwise triangle",
                cagd::affine::signed_area(&triangle[0], &triangle[1], &triangle[2]) < 0.0,
            ),
            (
                "collinear triple",
                cagd::affine::signed_area(a, b, c) == 0.0 && a != b && b != c,
            ),
            ("repeated in a triple", a == b || b == c || c == a),
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
