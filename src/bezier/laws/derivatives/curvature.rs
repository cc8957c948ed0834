//! Laws of the curvature at the ends.

use crate::affine::{Point, Vector};
use crate::bezier::BezierCurve;
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// `bezier-end-curvature`, in the plane:
/// κ(0) = (n − 1)/n·det(b₁ − b₀, b₂ − b₁)/‖b₁ − b₀‖³ and
/// κ(1) = (n − 1)/n·det(bₙ₋₁ − bₙ₋₂, bₙ − bₙ₋₁)/‖bₙ − bₙ₋₁‖³.
///
/// `implementation(curve, u)` must give κ·|κ|, which needs no root, or nothing where b′ = 0.
/// The degree is at least 2.
///
/// # Rounding
///
/// At an end the triangle is exact. b′ passes 4 roundings, b″ 7, a product of them 12 and their determinant
/// 13; that squared 27. ⟨b′, b′⟩ passes 10, its cube 32, the quotient 1. On the other side: 4 for a determinant, 9
/// squared, 14 for the cube, 4 for the quotient and the factor. Together at most 96.
/// With Δ and Δ′ the leg at the end and its neighbour, the terms of the determinant sum to at most
/// ‖Δ‖(‖Δ‖ + ‖Δ′‖) times its factor, hence those of κ·|κ| to ((n − 1)/n)²·(‖Δ‖ + ‖Δ′‖)²/‖Δ‖⁴.
pub fn end_curvature<T: OrderedScalar>(
    implementation: impl Fn(&BezierCurve<Point<T, 2>>, T) -> Option<T>,
    curve: &BezierCurve<Point<T, 2>>,
) -> Sides<T> {
    at_ends(implementation, curve, |leg, before, after| {
        let determinant =
            before[0].clone() * after[1].clone() - before[1].clone() * after[0].clone();
        determinant.clone() * determinant.abs() / cube(&square(leg))
    })
}

/// `bezier-end-curvature`, in space: the same with ‖(b₁ − b₀) × (b₂ − b₁)‖ instead of the determinant.
///
/// `implementation(curve, u)` must give κ², or nothing where b′ = 0.
///
/// # Rounding
///
/// As in the plane, with two more for the longer sums of three squares on each side.
pub fn end_curvature_in_space<T: Scalar>(
    implementation: impl Fn(&BezierCurve<Point<T, 3>>, T) -> Option<T>,
    curve: &BezierCurve<Point<T, 3>>,
) -> Sides<T> {
    at_ends(implementation, curve, |leg, before, after| {
        square(&before.cross(after)) / cube(&square(leg))
    })
}

/// Compares both ends; `squared(leg, before, after)` is the formula without the factor (n − 1)/n.
fn at_ends<T: Scalar, const D: usize>(
    implementation: impl Fn(&BezierCurve<Point<T, D>>, T) -> Option<T>,
    curve: &BezierCurve<Point<T, D>>,
    squared: impl Fn(&Vector<T, D>, &Vector<T, D>, &Vector<T, D>) -> T,
) -> Sides<T> {
    let n = curve.degree();
    let legs: Vec<Vector<T, D>> = curve
        .control_points()
        .windows(2)
        .map(|pair| pair[1].clone() - pair[0].clone())
        .collect();
    let mut sides = Sides::new(curve);
    let [start, end] = [curve.domain().start(), curve.domain().end()];
    let ends = [
        (
            "κ at the start depends on the first three control points",
            start,
            0,
            [0, 1],
        ),
        (
            "κ at the end depends on the last three control points",
            end,
            n - 1,
            [n - 2, n - 1],
        ),
    ];
    let mut singular_ends = [0, 0];
    for (name, u, leg, [before, after]) in ends {
        let found = implementation(curve, u);
        let singular = square(&legs[leg]).is_zero();
        let factor = T::from_ratio(n as i64 - 1, n as i64);
        let expected = (!singular).then(|| {
            factor.clone() * factor.clone() * squared(&legs[leg], &legs[before], &legs[after])
        });
        let length = |vector: &Vector<T, D>| vector.map(|x| x.magnitude()).norm();
        let neighbour = if leg == before { after } else { before };
        let size = length(&legs[leg]);
        let magnitude =
            ((n - 1) as f64 / n as f64 * (size + length(&legs[neighbour])) / (size * size)).powi(2);
        singular_ends[0] += i64::from(found.is_none());
        singular_ends[1] += i64::from(expected.is_none());
        sides = sides.equal(name, found, expected, Rounding::new(100, magnitude));
    }
    sides.equal(
        "the ends without a curvature are those with a leg of length 0",
        [T::from_integer(singular_ends[0])],
        [T::from_integer(singular_ends[1])],
        Rounding::none(),
    )
}

fn square<T: Scalar, const D: usize>(vector: &Vector<T, D>) -> T {
    vector
        .iter()
        .fold(T::zero(), |sum, x| sum + x.clone() * x.clone())
}

fn cube<T: Scalar>(x: &T) -> T {
    x.clone() * x.clone() * x.clone()
}
