//! Barycentric coordinates on lines, in triangles and in simplices, with equality.
//!
//! For one basis the claims are affine in the weights, so that the corners prove them; the bases are all those of a
//! small lattice.

use cagd::affine::{AffineBasis, Frame, Point, laws, line_coordinates};
use cagd::scalar::BigRational;

use crate::inputs::{at, for_each, integer, ratio};
use crate::support::mutants::affine::barycentric as mutants;
use crate::support::{holds, rejects};

type Exact = BigRational;
type Point2 = Point<Exact, 2>;
type Corners = [Point2; 3];

/// The points of the lattice {0, …, size − 1}².
fn lattice(size: i64) -> impl Iterator<Item = Point2> + Clone {
    (0..size * size).map(move |k| at(&[k / size, k % size]))
}

/// All triples of the lattice {0, 1, 2}², also repeated and collinear ones.
fn triples() -> impl Iterator<Item = Corners> {
    lattice(3).flat_map(|a| {
        lattice(3).flat_map(move |b| {
            let a = a.clone();
            lattice(3).map(move |c| [a.clone(), b.clone(), c])
        })
    })
}

/// All bases among them.
fn bases() -> impl Iterator<Item = AffineBasis<Exact, 2>> {
    triples().filter_map(|points| AffineBasis::new(points).ok())
}

/// Weights with one 1 and zeros, and a mixture that has a negative one.
fn weights<const N: usize>() -> impl Iterator<Item = [Exact; N]> {
    let corners = (0..N).map(|one| std::array::from_fn(|i| integer(i64::from(i == one))));
    let mixed = std::array::from_fn(|i| match i {
        0 => integer(1) - ratio((N * (N - 1)) as i64 / 2, 3),
        i => ratio(i as i64, 3),
    });
    corners.chain([mixed])
}

/// A simplex of each dimension, with a law for it.
fn simplex<const D: usize>() -> AffineBasis<Exact, D> {
    let corner = |i: usize| {
        Point::new(std::array::from_fn(|k| {
            integer((i * i) as i64) + integer(if k < i { 3 } else { -(k as i64) })
        }))
    };
    AffineBasis::new((0..=D).map(corner)).expect("the corners are independent")
}

#[test]
fn basis_barycentric_coordinates() {
    type Coordinates<const D: usize> = fn(&AffineBasis<Exact, D>, &Point<Exact, D>) -> Vec<Exact>;
    fn law<const D: usize, const N: usize>(
        implementation: Coordinates<D>,
        bases: impl IntoIterator<Item = AffineBasis<Exact, D>>,
    ) -> crate::support::Outcome {
        let inputs = bases
            .into_iter()
            .flat_map(|basis| weights::<N>().map(move |weights| (basis.clone(), weights)));
        for_each(inputs, |(basis, weights)| {
            laws::basis_barycentric_coordinates(implementation, basis, weights)
        })
    }
    holds(law::<2, 3>(AffineBasis::coordinates, bases()));
    holds(law::<1, 2>(AffineBasis::coordinates, [simplex()]));
    holds(law::<3, 4>(AffineBasis::coordinates, [simplex()]));
    holds(law::<4, 5>(AffineBasis::coordinates, [simplex()]));
    rejects(
        "order reversed",
        law::<3, 4>(mutants::order_reversed, [simplex()]),
    );
    rejects(
        "first weight 0",
        law::<3, 4>(mutants::first_weight_forgotten, [simplex()]),
    );
    rejects(
        "first weight too large",
        law::<2, 3>(mutants::first_weight_too_large, bases()),
    );
}

#[test]
fn frame_equivalence() {
    fn law<const D: usize, const N: usize>(
        implementation: fn(&AffineBasis<Exact, D>) -> Frame<Exact, D>,
        bases: impl IntoIterator<Item = AffineBasis<Exact, D>>,
    ) -> crate::support::Outcome {
        let inputs = bases
            .into_iter()
            .flat_map(|basis| weights::<N>().map(move |weights| (basis.clone(), weights)));
        for_each(inputs, |(basis, weights)| {
            laws::frame_equivalence(implementation, basis, weights)
        })
    }
    holds(law::<2, 3>(AffineBasis::frame, bases()));
    holds(law::<1, 2>(AffineBasis::frame, [simplex()]));
    holds(law::<3, 4>(AffineBasis::frame, [simplex()]));
    rejects(
        "consecutive differences",
        law::<3, 4>(mutants::consecutive_differences, [simplex()]),
    );
    rejects(
        "points for vectors",
        law::<2, 3>(mutants::points_for_vectors, bases()),
    );
    rejects(
        "the last for the origin",
        law::<3, 4>(mutants::last_point_for_origin, [simplex()]),
    );
}

#[test]
fn basis_of_differences() {
    let law = |implementation: fn(&Corners) -> bool| {
        for_each(triples(), |points| {
            laws::basis_of_differences(implementation, points)
        })
    };
    holds(law(|points| AffineBasis::new(points.clone()).is_ok()));
    rejects("different points", law(mutants::different_points));
    rejects("as vectors", law(mutants::independent_as_vectors));
}

/// Both sides of the first three claims are affine in t, those of the last are quadratic: three parameters prove them
/// for a pair of points.
#[test]
fn barycentric_on_line() {
    type Coordinates = fn(&Point2, &Point2, &Point2) -> Option<[Exact; 2]>;
    let parameters = [
        ratio(-3, 2),
        integer(0),
        ratio(1, 3),
        integer(1),
        integer(2),
    ];
    let law = |implementation: Coordinates| {
        let pairs = lattice(3).flat_map(|a| lattice(3).map(move |b| (a.clone(), b)));
        let inputs = pairs
            .filter(|(a, b)| a != b)
            .flat_map(|(a, b)| parameters.clone().map(|t| (a.clone(), b.clone(), t)));
        for_each(inputs, |(a, b, t)| {
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

/// Both sides are affine in G, so that three points that are no line prove the claim for a triangle.
#[test]
fn barycentric_in_triangle() {
    type Coordinates = fn(&Corners, &Point2) -> [Exact; 3];
    let places = [[0, 0], [5, 1], [-1, 2]].map(|place| at::<Point2>(&place));
    let law = |implementation: Coordinates| {
        let triangles = triples().filter(|points| AffineBasis::new(points.clone()).is_ok());
        let inputs =
            triangles.flat_map(|points| places.clone().map(|place| (points.clone(), place)));
        for_each(inputs, |(triangle, g)| {
            laws::barycentric_in_triangle(implementation, triangle, g)
        })
    };
    holds(law(|triangle, g| {
        let basis = AffineBasis::new(triangle.clone()).expect("not flat");
        basis.coordinates(g).try_into().expect("three coordinates")
    }));
    rejects("a cyclic shift", law(mutants::next_sides));
    rejects("without signs", law(mutants::unsigned_areas));
    rejects("not divided", law(mutants::not_divided));
}
