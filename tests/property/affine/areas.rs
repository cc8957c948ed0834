//! Properties of areas.

use cagd::affine::{
    BoundingBox, LatticeCount, LatticePoint, LatticePolygon, MonteCarloEstimate, Point, laws,
    signed_area,
};
use cagd::law::{Rounding, Sides};
use proptest::prelude::*;

use crate::generators::{for_all, for_all_of, polygon};
use crate::support::mutants::affine::areas as mutants;
use crate::support::{holds, rejects};

type Place = Point<f64, 2>;

#[test]
fn triangle_area_determinant() {
    let law = |implementation: fn(&Place, &Place, &Place) -> f64| {
        for_all(polygon(), |points| {
            let last = points.len() - 1;
            let [r, p, q] = [points[0], points[last / 2], points[last]];
            laws::triangle_area_determinant(implementation, &r, &p, &q)
        })
    };
    holds(law(signed_area));
    rejects("the parallelogram", law(mutants::parallelogram));
    rejects("without its sign", law(mutants::without_sign));
    rejects("from the origin", law(mutants::from_the_origin));
    rejects("plus for minus", law(mutants::plus_for_minus));
}

/// Simple lattice polygons: between two chains over the same columns, sheared, in both orientations; vertices at which the way
/// goes straight on are frequent.
fn lattice_polygons() -> impl Strategy<Value = LatticePolygon> {
    let columns = prop::collection::vec((-4i64..=4, 1i64..=4), 1..=7);
    (columns, -2i64..=2, -2i64..=2, any::<bool>()).prop_map(|(columns, a, b, clockwise)| {
        // A triangle at least: the chains meet in one point to the left.
        let lower = columns
            .iter()
            .enumerate()
            .map(|(x, (low, _))| [x as i64 + 1, *low]);
        let upper = columns
            .iter()
            .enumerate()
            .map(|(x, (low, height))| [x as i64 + 1, low + height]);
        let start = [0, columns[0].0];
        let around = std::iter::once(start).chain(lower).chain(upper.rev());
        let sheared = around.map(|[x, y]| {
            let x = x + a * y;
            [x, y + b * x]
        });
        let mut vertices: Vec<LatticePoint> = sheared.collect();
        if clockwise {
            vertices.reverse();
        }
        LatticePolygon::new(vertices).expect("chains that do not meet")
    })
}

#[test]
fn pick_theorem() {
    let law = |implementation: fn(&LatticePolygon) -> LatticeCount| {
        for_all(lattice_polygons(), |polygon| {
            laws::pick_theorem::<f64>(implementation, polygon)
        })
    };
    holds(law(LatticePolygon::count));
    rejects("vertices only", law(mutants::vertices_only));
    rejects("the boundary twice", law(mutants::boundary_counted_twice));
    rejects("the vertices twice", law(mutants::vertices_twice));
}

#[test]
fn primitive_triangles() {
    let law = |implementation: fn(&LatticePolygon) -> Vec<[LatticePoint; 3]>| {
        for_all_of(64, lattice_polygons(), |polygon| {
            laws::primitive_triangles::<f64>(implementation, polygon)
        })
    };
    holds(law(LatticePolygon::primitive_triangles));
    rejects("any triangles", law(mutants::any_triangles));
    rejects("one triangle less", law(mutants::one_triangle_missing));
}

/// The triangles of a triangulation have areas of one sign, and their sum is the area of the polygon. Exact: the
/// vertices have small whole coordinates.
#[test]
fn triangulation() {
    let law = |triangulate: fn(&LatticePolygon) -> Vec<[usize; 3]>| {
        for_all(lattice_polygons(), |polygon| {
            let vertices = polygon.polygon().vertices();
            let orientation = polygon.polygon().signed_area().signum();
            let areas: Vec<f64> = triangulate(polygon)
                .into_iter()
                .map(|[i, j, k]| {
                    orientation * signed_area(&vertices[i], &vertices[j], &vertices[k])
                })
                .collect();
            Sides::new(format!("{:?}", polygon.vertices()))
                .equal(
                    "the areas sum to that of the polygon",
                    [areas.iter().sum::<f64>()],
                    [polygon.area()],
                    Rounding::none(),
                )
                .at_most(
                    "no triangle is flat or turned over",
                    vec![0.5; areas.len()],
                    areas,
                    Rounding::none(),
                )
        })
    };
    holds(law(|polygon| polygon.polygon().triangulation()));
    rejects(
        "all triangles from the first vertex",
        law(|polygon| {
            (2..polygon.vertices().len())
                .map(|k| [0, k - 1, k])
                .collect()
        }),
    );
}

type Contains<'a, const D: usize> = &'a dyn Fn(&Point<f64, D>) -> bool;
type Estimate<const D: usize> =
    fn(&BoundingBox<Point<f64, D>>, usize, u64, Contains<D>) -> MonteCarloEstimate;

/// Boxes of many sizes, given by a corner and the lengths of the sides.
fn boxes() -> impl Strategy<Value = ([f64; 2], [f64; 2])> {
    let scale = prop_oneof![4 => Just(1.0), 1 => Just(1e100), 1 => Just(1e-100)];
    ([-8.0..8.0, -8.0..8.0], [0.1..8.0, 0.1..8.0], scale).prop_map(
        |(low, size, scale): ([f64; 2], [f64; 2], f64)| {
            (low.map(|x| x * scale), size.map(|x| x * scale))
        },
    )
}

/// In the plane ellipses and triangles, in space boxes; fractions of the box are planted.
#[test]
fn monte_carlo_area() {
    let draws = || (200..2000_usize, any::<u64>());
    let plane = |implementation: Estimate<2>| {
        for_all_of(
            48,
            (boxes(), draws(), 0.1..1.0),
            |((low, size), draws, radius)| {
                let bounds = bounds_of(*low, *size);
                let local = |x: &Place| [0, 1].map(|k| (x[k] - low[k]) / size[k]);
                let ellipse = |x: &Place| {
                    let [u, v] = local(x).map(|t| 2.0 * t - 1.0);
                    u * u + v * v <= radius * radius
                };
                let triangle = |x: &Place| {
                    let [u, v] = local(x);
                    u + v <= *radius
                };
                let whole = size[0] * size[1];
                let of_ellipse = whole * std::f64::consts::FRAC_PI_4 * radius * radius;
                let of_triangle = whole * 0.5 * radius * radius;
                laws::monte_carlo_area(implementation, &bounds, *draws, &ellipse, of_ellipse).and(
                    laws::monte_carlo_area(implementation, &bounds, *draws, &triangle, of_triangle),
                )
            },
        )
    };
    let space = for_all_of(24, (draws(), 0.0..1.0), |(draws, height)| {
        let bounds = bounds_of([-1.0, 0.0, 2.0], [2.0, 3.0, 1.0]);
        let inside = |x: &Point<f64, 3>| x[2] <= 2.0 + height && x[0] >= 0.0;
        laws::monte_carlo_area(mutants::estimate, &bounds, *draws, &inside, 3.0 * height)
    });
    holds(plane(mutants::estimate));
    holds(space);
    rejects("the share of hits alone", plane(mutants::share_of_hits));
    rejects("the points outside", plane(mutants::misses_counted));
    rejects(
        "points on the diagonal only",
        plane(mutants::on_the_diagonal),
    );
    rejects("more in the middle", plane(mutants::not_uniform));
}

fn bounds_of<const D: usize>(low: [f64; D], size: [f64; D]) -> BoundingBox<Point<f64, D>> {
    let high = std::array::from_fn(|k| low[k] + size[k]);
    BoundingBox::of(&[Point::new(low), Point::new(high)]).expect("finite corners")
}
