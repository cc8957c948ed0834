//! Wrong areas and counts.

use cagd::affine::{
    BoundingBox, LatticeCount, LatticePoint, LatticePolygon, MonteCarloEstimate, Point,
    UniformPoints, monte_carlo, signed_area,
};
use cagd::scalar::{OrderedScalar, Scalar};

type Place<T> = Point<T, 2>;

/// Forgets to halve: the parallelogram.
pub fn parallelogram<T: Scalar>(r: &Place<T>, p: &Place<T>, q: &Place<T>) -> T {
    signed_area(r, p, q) * T::from_integer(2)
}

/// Forgets the sign.
pub fn without_sign<T: OrderedScalar>(r: &Place<T>, p: &Place<T>, q: &Place<T>) -> T {
    signed_area(r, p, q).abs()
}

/// Takes positions for edges: half of det(P, Q), whatever R is.
pub fn from_the_origin<T: Scalar>(_: &Place<T>, p: &Place<T>, q: &Place<T>) -> T {
    signed_area(&Point::origin(), p, q)
}

/// Adds the products in place of subtracting them.
pub fn plus_for_minus<T: Scalar>(r: &Place<T>, p: &Place<T>, q: &Place<T>) -> T {
    let [v, w] = [p.clone() - r.clone(), q.clone() - r.clone()];
    (v[0].clone() * w[1].clone() + v[1].clone() * w[0].clone()) * T::from_ratio(1, 2)
}

/// Counts the vertices only, not the lattice points between them.
pub fn vertices_only(polygon: &LatticePolygon) -> LatticeCount {
    LatticeCount {
        boundary: polygon.vertices().len(),
        ..polygon.count()
    }
}

/// Counts the points of the boundary as points inside as well.
pub fn boundary_counted_twice(polygon: &LatticePolygon) -> LatticeCount {
    let LatticeCount { interior, boundary } = polygon.count();
    LatticeCount {
        interior: interior + boundary,
        boundary,
    }
}

/// Counts both ends of each edge, so that each vertex counts twice.
pub fn vertices_twice(polygon: &LatticePolygon) -> LatticeCount {
    let LatticeCount { interior, boundary } = polygon.count();
    LatticeCount {
        interior,
        boundary: boundary + polygon.vertices().len(),
    }
}

/// Stops at the triangles of the first triangulation.
pub fn any_triangles(polygon: &LatticePolygon) -> Vec<[LatticePoint; 3]> {
    let triangles = polygon.polygon().triangulation().into_iter();
    triangles
        .map(|triangle| triangle.map(|i| polygon.vertices()[i]))
        .collect()
}

/// Forgets one triangle.
pub fn one_triangle_missing(polygon: &LatticePolygon) -> Vec<[LatticePoint; 3]> {
    polygon.primitive_triangles().split_off(1)
}

type Contains<'a, const D: usize> = &'a dyn Fn(&Point<f64, D>) -> bool;
type Bounds<const D: usize> = BoundingBox<Point<f64, D>>;

/// The library's estimate.
pub fn estimate<const D: usize>(
    bounds: &Bounds<D>,
    samples: usize,
    seed: u64,
    contains: Contains<D>,
) -> MonteCarloEstimate {
    monte_carlo(bounds, samples, seed, contains).expect("samples, and a box with an area")
}

/// Forgets the box: gives the share of hits.
pub fn share_of_hits<const D: usize>(
    bounds: &Bounds<D>,
    samples: usize,
    seed: u64,
    contains: Contains<D>,
) -> MonteCarloEstimate {
    MonteCarloEstimate {
        box_area: 1.0,
        ..estimate(bounds, samples, seed, contains)
    }
}

/// Counts the points outside.
pub fn misses_counted<const D: usize>(
    bounds: &Bounds<D>,
    samples: usize,
    seed: u64,
    contains: Contains<D>,
) -> MonteCarloEstimate {
    estimate(bounds, samples, seed, &|point| !contains(point))
}

/// Uses one random number for all coordinates, so that all points lie on the diagonal.
pub fn on_the_diagonal<const D: usize>(
    bounds: &Bounds<D>,
    samples: usize,
    seed: u64,
    contains: Contains<D>,
) -> MonteCarloEstimate {
    let (low, size) = (*bounds.low(), bounds.size());
    let on_diagonal = |point: &Point<f64, D>| {
        let t = (point[0] - low[0]) / size[0];
        contains(&(low + size * t))
    };
    estimate(bounds, samples, seed, &on_diagonal)
}

/// Draws around the centre of the box more often than near its sides: means of two points.
pub fn not_uniform<const D: usize>(
    bounds: &Bounds<D>,
    samples: usize,
    seed: u64,
    contains: Contains<D>,
) -> MonteCarloEstimate {
    let mut points = UniformPoints::new(*bounds, seed);
    let mut hits = 0;
    for _ in 0..samples {
        let pair = [points.next(), points.next()].map(|point| point.expect("they never end"));
        hits += usize::from(contains(&(pair[0] + (pair[1] - pair[0]) * 0.5)));
    }
    MonteCarloEstimate {
        hits,
        ..estimate(bounds, samples, seed, contains)
    }
}
