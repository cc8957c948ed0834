//! Mistakes with barycentric coordinates.

use cagd::affine::{
    Affine, AffineBasis, Frame, Point, Vector, line_coordinates, plane_determinant, signed_area,
};
use cagd::scalar::{OrderedScalar, Scalar};
use num_traits::{One, Zero};

// ── coordinates in a basis ──

/// Lists the coordinates from the last to the first.
pub fn order_reversed<T: Scalar, const D: usize>(
    basis: &AffineBasis<T, D>,
    point: &Point<T, D>,
) -> Vec<T> {
    basis.coordinates(point).into_iter().rev().collect()
}

/// Gives the first point no weight, so that the coordinates are those of a frame.
pub fn first_weight_forgotten<T: Scalar, const D: usize>(
    basis: &AffineBasis<T, D>,
    point: &Point<T, D>,
) -> Vec<T> {
    let mut coordinates = basis.coordinates(point);
    coordinates[0] = T::zero();
    coordinates
}

/// Adds the others to 1 instead of subtracting them.
pub fn first_weight_too_large<T: Scalar, const D: usize>(
    basis: &AffineBasis<T, D>,
    point: &Point<T, D>,
) -> Vec<T> {
    let mut coordinates = basis.coordinates(point);
    coordinates[0] = T::one() + T::one() - coordinates[0].clone();
    coordinates
}

// ── frames ──

fn frame<T: Scalar, const D: usize>(
    basis: &AffineBasis<T, D>,
    origin: usize,
    axis: impl Fn(usize) -> Vector<T, D>,
) -> Frame<T, D> {
    let wrong = Frame::new(
        basis.points()[origin].clone(),
        std::array::from_fn(|i| axis(i + 1)),
    );
    // Where the mistake gives no frame at all, it does not show.
    wrong.unwrap_or_else(|_| basis.frame())
}

/// Takes Aᵢ − Aᵢ₋₁, from each point to the next.
pub fn consecutive_differences<T: Scalar, const D: usize>(
    basis: &AffineBasis<T, D>,
) -> Frame<T, D> {
    let points = basis.points();
    frame(basis, 0, |i| points[i].difference(&points[i - 1]))
}

/// Takes the points themselves for vectors, as “(A₀, Aᵢ)” in the class notes can be read.
pub fn points_for_vectors<T: Scalar, const D: usize>(basis: &AffineBasis<T, D>) -> Frame<T, D> {
    frame(basis, 0, |i| basis.points()[i].from_origin())
}

/// Takes the last point for the origin, but the vectors from the first.
pub fn last_point_for_origin<T: Scalar, const D: usize>(basis: &AffineBasis<T, D>) -> Frame<T, D> {
    let points = basis.points();
    frame(basis, D, |i| points[i].difference(&points[0]))
}

/// Believes that different points are a basis.
pub fn different_points<T: Scalar>(points: &[Point<T, 2>; 3]) -> bool {
    let [a, b, c] = points;
    a != b && b != c && c != a
}

/// Asks whether A₁ and A₂ are independent, as if they were vectors.
pub fn independent_as_vectors<T: Scalar>(points: &[Point<T, 2>; 3]) -> bool {
    let [_, b, c] = points;
    !plane_determinant(&b.from_origin(), &c.from_origin()).is_zero()
}

// ── on a line ──

/// Gives each point the length on its own side of G.
pub fn own_side<P: Affine>(a: &P, b: &P, g: &P) -> Option<[P::Scalar; 2]> {
    let [alpha, beta] = line_coordinates(a, b, g).ok()?;
    Some([beta, alpha])
}

/// Takes lengths without signs.
pub fn unsigned_lengths<P: Affine<Scalar: OrderedScalar>>(
    a: &P,
    b: &P,
    g: &P,
) -> Option<[P::Scalar; 2]> {
    let coordinates = line_coordinates(a, b, g).ok()?;
    Some(coordinates.map(|x| OrderedScalar::abs(&x)))
}

/// Knows no points outside the segment.
pub fn inside_only<P: Affine<Scalar: OrderedScalar>>(
    a: &P,
    b: &P,
    g: &P,
) -> Option<[P::Scalar; 2]> {
    let coordinates = line_coordinates(a, b, g).ok()?;
    let inside = coordinates.iter().all(|x| *x >= P::Scalar::zero());
    inside.then_some(coordinates)
}

/// Gives the ratio (G − A) : (B − G) for β and forgets to divide by the whole.
pub fn ratio_for_coordinate<P: Affine>(a: &P, b: &P, g: &P) -> Option<[P::Scalar; 2]> {
    let [alpha, beta] = line_coordinates(a, b, g).ok()?;
    let ratio = if alpha.is_zero() { beta } else { beta / alpha };
    Some([P::Scalar::one() - ratio.clone(), ratio])
}

// ── in a triangle ──

type Corners<T> = [Point<T, 2>; 3];

/// Gives α the triangle ABG and so on, as the class notes do: a cyclic shift.
pub fn next_sides<T: Scalar>([a, b, c]: &Corners<T>, g: &Point<T, 2>) -> [T; 3] {
    let whole = signed_area(a, b, c);
    [(a, b), (b, c), (c, a)].map(|(p, q)| signed_area(p, q, g) / whole.clone())
}

/// Takes areas without signs.
pub fn unsigned_areas<T: OrderedScalar>([a, b, c]: &Corners<T>, g: &Point<T, 2>) -> [T; 3] {
    let whole = signed_area(a, b, c);
    [(b, c), (c, a), (a, b)]
        .map(|(p, q)| OrderedScalar::abs(&(signed_area(p, q, g) / whole.clone())))
}

/// Forgets to divide by the whole triangle.
pub fn not_divided<T: Scalar>([a, b, c]: &Corners<T>, g: &Point<T, 2>) -> [T; 3] {
    [(b, c), (c, a), (a, b)].map(|(p, q)| signed_area(p, q, g))
}
