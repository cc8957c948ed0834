use cagd::affine::Point;
use cagd::check::{Picture, claim};
use proptest::prelude::*;

fn probes() -> Vec<String> {
    cagd::probes![
        answer::twice_area(&[[0, 0], [2, 1], [1, 3]]),
        answer::twice_area(&[[1, 3], [2, 1], [0, 0]]),
        answer::twice_area(&[[1, 2], [5, 3], [4, 7], [3, 4]]),
        answer::twice_area(&[[3, 1], [6, 1], [6, 5], [3, 4], [2, 3]]),
    ]
}

fn compare(vertices: &[[i64; 2]], expected: i64) {
    let corner = |xy: [i64; 2]| Point::new(xy.map(|n| n as f64));
    claim("twice the area")
        .input(format!("the vertices {vertices:?}"))
        .picture(|| {
            let corners = vertices.iter().chain(vertices.first());
            Picture::new().given(corners.map(|&xy| corner(xy)))
        })
        .equal(answer::twice_area(vertices), expected);
}

/// The same polygon, its vertices in the other order.
fn reversed(vertices: &[[i64; 2]]) -> Vec<[i64; 2]> {
    vertices.iter().rev().copied().collect()
}

/// Why: half the product of two sides.
#[test]
fn a_triangle_at_the_origin() {
    compare(&[[0, 0], [4, 0], [0, 3]], 12);
    compare(&[[0, 0], [2, 1], [1, 3]], 5);
}

/// Why: the order of the vertices gives the sign.
#[test]
fn a_clockwise_triangle() {
    compare(&[[0, 0], [0, 3], [4, 0]], -12);
}

/// Why: a rectangle far from the origin, where the last edge counts.
#[test]
fn a_rectangle() {
    compare(&[[5, 2], [8, 2], [8, 4], [5, 4]], 12);
}

/// Why: a field with a dent, and one with vertices in the middle of an edge.
#[test]
fn dents_and_straight_vertices() {
    // A square of side 4 without the triangle from its upper side down to (2, 1).
    compare(&[[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]], 32 - 12);
    compare(&[[1, 1], [2, 1], [4, 1], [4, 3], [1, 3]], 12);
}

/// Why: a field has one area, whoever measures it, from whatever corner and origin.
#[test]
fn another_first_vertex_and_another_origin() {
    let field = [[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]];
    let here = answer::twice_area(&field);
    for first in 1..5 {
        let mut there = field.map(|[x, y]| [x + 3, y - 7]);
        there.rotate_left(first);
        claim("twice the area of a polygon that was moved, from another vertex on")
            .input(format!("first {field:?}, then {there:?}"))
            .equal(answer::twice_area(&there), here);
    }
}

/// Why: products of coordinates of this size still fit.
#[test]
fn a_large_field() {
    let m = 1_000_000;
    compare(&[[-m, -m], [m, -m], [m, m], [-m, m]], 8 * m * m);
}

proptest! {
    /// Why: a pile of rectangles of height 1, whose areas are added; it is dented on both sides.
    #[test]
    fn piles_of_rectangles(
        rows in proptest::collection::vec((-9..0_i64, 1..9_i64), 1..6), x in -99..99_i64, y in -99..99_i64,
        start in 0..20_usize,
    ) {
        let right = rows.iter().zip(y..).flat_map(|(&(_, right), y)| [[x + right, y], [x + right, y + 1]]);
        let left = rows.iter().zip(y..).flat_map(|(&(left, _), y)| [[x + left, y], [x + left, y + 1]]);
        let left: Vec<_> = left.collect();
        let mut vertices: Vec<_> = right.chain(left.into_iter().rev()).collect();
        vertices.dedup();
        let count = vertices.len();
        vertices.rotate_left(start % count);
        let area: i64 = rows.iter().map(|(left, right)| right - left).sum();
        compare(&vertices, 2 * area);
        compare(&reversed(&vertices), -2 * area);
    }
}
