//! Areas over rationals.

use cagd::affine::{LatticeCount, LatticePoint, LatticePolygon, Point, laws, signed_area};
use cagd::scalar::BigRational;

use crate::inputs::{at, for_each};
use crate::support::mutants::affine::areas as mutants;
use crate::support::{holds, rejects};

type Exact = BigRational;
type Place = Point<Exact, 2>;

/// The equations are proved: both sides are affine in each point, so the triples of the origin and the unit points are
/// enough. The sign is checked, at points farther away too.
#[test]
fn triangle_area_determinant() {
    let points: Vec<Place> = [[0, 0], [1, 0], [0, 1], [7, -3], [-2, 5], [12, -11]]
        .map(|p| at(&p))
        .into();
    let law = |implementation: fn(&Place, &Place, &Place) -> Exact| {
        let triples = points.iter().flat_map(|r| {
            let pairs = points
                .iter()
                .flat_map(|p| points.iter().map(move |q| (p, q)));
            pairs.map(move |(p, q)| [r, p, q])
        });
        for_each(triples, |[r, p, q]| {
            laws::triangle_area_determinant(implementation, r, p, q)
        })
    };
    holds(law(signed_area));
    rejects("the parallelogram", law(mutants::parallelogram));
    rejects("without its sign", law(mutants::without_sign));
    rejects("from the origin", law(mutants::from_the_origin));
    rejects("plus for minus", law(mutants::plus_for_minus));
}

/// All triangles with corners in the 5 × 5 grid, and all quadrangles, the arrows among them, in the 4 × 3 grid, each in
/// one order; then a comb, a spiral and a frame that is cut open.
fn polygons() -> Vec<LatticePolygon> {
    let grid = |width: i64, i: i64| [i % width, i / width];
    let triangles = (0..25).flat_map(|i| {
        (i + 1..25)
            .flat_map(move |j| (j + 1..25).map(move |k| [i, j, k].map(|n| grid(5, n)).to_vec()))
    });
    let quadrangles = (0..12_i64.pow(4))
        .map(|choice| [0, 1, 2, 3].map(|k| choice / 12_i64.pow(k) % 12))
        .filter(|[a, b, c, d]| a < b && a < c && a < d && b < d)
        .map(|corners| corners.map(|n| grid(4, n)).to_vec());
    let comb: &[LatticePoint] = &[
        [0, 0],
        [6, 0],
        [6, 4],
        [5, 1],
        [4, 4],
        [3, 1],
        [2, 4],
        [1, 1],
        [0, 4],
    ];
    let spiral: &[LatticePoint] = &[
        [0, 0],
        [8, 0],
        [8, 7],
        [0, 7],
        [0, 2],
        [6, 2],
        [6, 5],
        [2, 5],
        [2, 4],
        [5, 4],
        [5, 3],
        [1, 3],
        [1, 6],
        [7, 6],
        [7, 1],
        [0, 1],
    ];
    let frame: &[LatticePoint] = &[
        [0, 0],
        [9, 0],
        [9, 9],
        [0, 9],
        [0, 5],
        [2, 5],
        [2, 7],
        [7, 7],
        [7, 2],
        [2, 2],
        [2, 4],
        [0, 4],
    ];
    let others = [comb, spiral, frame]
        .map(|vertices| LatticePolygon::new(vertices.iter().copied()).expect("a simple polygon"));
    triangles
        .chain(quadrangles)
        .filter_map(|vertices| LatticePolygon::new(vertices).ok())
        .chain(others)
        .collect()
}

/// Checked for 2739 polygons.
#[test]
fn pick_theorem() {
    let polygons = polygons();
    assert!(polygons.len() >= 2739, "{} polygons", polygons.len());
    let law = |implementation: fn(&LatticePolygon) -> LatticeCount| {
        for_each(&polygons, |polygon| {
            laws::pick_theorem::<Exact>(implementation, polygon)
        })
    };
    holds(law(LatticePolygon::count));
    rejects("vertices only", law(mutants::vertices_only));
    rejects("the boundary twice", law(mutants::boundary_counted_twice));
    rejects("the vertices twice", law(mutants::vertices_twice));
}

/// Checked for every seventh of these polygons.
#[test]
fn primitive_triangles() {
    let polygons = polygons();
    let law = |implementation: fn(&LatticePolygon) -> Vec<[LatticePoint; 3]>| {
        for_each(polygons.iter().rev().step_by(7), |polygon| {
            laws::primitive_triangles::<Exact>(implementation, polygon)
        })
    };
    holds(law(LatticePolygon::primitive_triangles));
    rejects("any triangles", law(mutants::any_triangles));
    rejects("one triangle less", law(mutants::one_triangle_missing));
}

#[test]
fn figure_pick() {
    let triangle = LatticePolygon::new([[0, 0], [2, 1], [1, 3]]).expect("a triangle");
    let law = |implementation: fn(&LatticePolygon) -> LatticeCount| {
        for_each([&triangle], |triangle| {
            laws::figure_pick::<Exact>(implementation, triangle)
        })
    };
    holds(law(LatticePolygon::count));
    rejects("the boundary twice", law(mutants::boundary_counted_twice));
    rejects("the vertices twice", law(mutants::vertices_twice));
}
