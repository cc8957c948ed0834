use cagd::affine::{LatticePolygon, Location, Point};
use cagd::check::{Picture, claim};
use proptest::prelude::*;

fn probes() -> Vec<String> {
    let both = |vertices: &[[i64; 2]]| {
        (
            answer::boundary_points(vertices),
            answer::interior_points(vertices),
        )
    };
    cagd::probes![
        both(&[[0, 0], [3, 0], [3, 2], [0, 2]]),
        both(&[[1, 1], [7, 3], [4, 8]]),
        both(&[[4, 8], [7, 3], [1, 1]]),
        both(&[[0, 0], [6, 0], [0, 9]]),
        both(&[[0, 0], [2, 1], [1, 3]]),
    ]
}

/// The polygon, closed, to be drawn.
fn outline(vertices: &[[i64; 2]]) -> Picture {
    let corners = vertices.iter().chain(vertices.first());
    Picture::new().given(corners.map(|xy| Point::new(xy.map(|n| n as f64))))
}

fn compare(vertices: &[[i64; 2]], boundary: i64, interior: i64) {
    claim("the number of lattice points on the boundary")
        .input(format!("the vertices {vertices:?}"))
        .picture(|| outline(vertices))
        .equal(answer::boundary_points(vertices), boundary);
    claim("the number of lattice points inside")
        .input(format!("the vertices {vertices:?}"))
        .picture(|| outline(vertices))
        .equal(answer::interior_points(vertices), interior);
}

/// Why: an edge may pass through lattice points between its ends, and its ends belong to two edges.
#[test]
fn boundaries() {
    for (vertices, expected) in [
        (vec![[0, 0], [3, 0], [3, 2], [0, 2]], 10),
        (vec![[0, 0], [2, 1], [1, 3]], 3),
        (vec![[0, 0], [6, 4], [0, 4]], 12),
        (vec![[3, 2], [-3, -2], [-3, 2]], 12),
        (vec![[0, 0], [1, 0], [3, 0], [3, 2], [0, 2]], 10),
    ] {
        claim("the number of lattice points on the boundary")
            .input(format!("the vertices {vertices:?}"))
            .picture(|| outline(&vertices))
            .equal(answer::boundary_points(&vertices), expected);
    }
}

/// Why: a rectangle, whose points one sees.
#[test]
fn a_rectangle() {
    compare(&[[0, 0], [3, 0], [3, 2], [0, 2]], 10, 2);
    compare(&[[0, 0], [1, 0], [1, 1], [0, 1]], 4, 0);
}

/// Why: the triangle of the book has no boundary points but its vertices.
#[test]
fn a_slanted_triangle() {
    compare(&[[0, 0], [2, 1], [1, 3]], 3, 2);
}

/// Why: an edge may pass through lattice points between its ends.
#[test]
fn edges_through_lattice_points() {
    compare(&[[0, 0], [6, 4], [0, 4]], 12, 7);
    compare(&[[-3, -2], [3, 2], [-3, 2]], 12, 7);
}

/// Why: the vertices may go round clockwise.
#[test]
fn clockwise() {
    compare(&[[0, 0], [0, 2], [3, 2], [3, 0]], 10, 2);
    compare(&[[0, 0], [1, 3], [2, 1]], 3, 2);
}

/// Why: a vertex in the middle of an edge changes nothing, and a dent takes points away.
#[test]
fn straight_vertices_and_dents() {
    compare(&[[0, 0], [1, 0], [3, 0], [3, 2], [0, 2]], 10, 2);
    compare(&[[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]], 14, 4);
}

/// Why: nobody counts these one by one.
#[test]
fn a_large_square() {
    let m = 1_000_000;
    let side = 2 * m - 1;
    compare(&[[-m, -m], [m, -m], [m, m], [-m, m]], 8 * m, side * side);
}

/// Lattice points on rays from the origin, one for each direction in turn, form a star around it.
fn star(lengths: &[i64]) -> Vec<[i64; 2]> {
    let directions = [
        [1, 0],
        [2, 1],
        [1, 2],
        [0, 1],
        [-1, 1],
        [-2, 1],
        [-1, 0],
        [-1, -2],
        [0, -1],
        [3, -2],
    ];
    directions
        .iter()
        .zip(lengths)
        .map(|(d, &length)| d.map(|x| x * length))
        .collect()
}

/// How many lattice points of the box around the polygon lie on its boundary and how many inside, found by trying all.
fn count(polygon: &LatticePolygon) -> (i64, i64) {
    let (mut boundary, mut interior) = (0, 0);
    for x in -10..=10 {
        for y in -10..=10 {
            match polygon
                .polygon()
                .locate(&Point::new([f64::from(x), f64::from(y)]))
            {
                Location::Boundary => boundary += 1,
                Location::Inside => interior += 1,
                Location::Outside => {}
            }
        }
    }
    (boundary, interior)
}

proptest! {
    /// Why: stars of every shape, either way round.
    #[test]
    fn stars(lengths in proptest::collection::vec(1..4_i64, 10), is_clockwise in any::<bool>()) {
        let mut vertices = star(&lengths);
        if is_clockwise {
            vertices.reverse();
        }
        let polygon = LatticePolygon::new(vertices.clone()).expect("a star is simple");
        let (boundary, interior) = count(&polygon);
        compare(&vertices, boundary, interior);
    }

    /// Why: any triangle that is one.
    #[test]
    fn triangles(vertices in proptest::array::uniform3([-6..=6_i64, -6..=6_i64])) {
        let polygon = LatticePolygon::new(vertices);
        prop_assume!(polygon.is_ok());
        if let Ok(polygon) = &polygon {
            let (boundary, interior) = count(polygon);
            compare(&vertices, boundary, interior);
        }
    }

    /// Why: both numbers stay the same if the polygon is moved.
    #[test]
    fn moved(vertices in proptest::array::uniform3([-6..=6_i64, -6..=6_i64]), x in -99..=99_i64, y in -99..=99_i64) {
        prop_assume!(LatticePolygon::new(vertices).is_ok());
        let there = vertices.map(|v| [v[0] + x, v[1] + y]);
        claim("both numbers for a triangle that was moved").equal(
            (answer::boundary_points(&there), answer::interior_points(&there)),
            (answer::boundary_points(&vertices), answer::interior_points(&vertices)),
        );
    }
}
