//! Laws of the distances between a curve, its chord and its control polygon.
//!
//! They are stated in the maximum norm, so that exact numbers need no root.

use num_traits::{One, Zero};

use super::largest_coordinate;
use super::subdivision::bernstein_sum;
use crate::affine::Affine;
use crate::bezier::bounds::{maximum_norm, segment_distance_squared};
use crate::bezier::subdivision::dyadic;
use crate::bezier::{BezierCurve, bernstein};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// `bezier-chord-bound`: |b(t) − L(t)| ≤ n(n − 1)/8·‖Δ²b‖ for 0 ≤ t ≤ 1, and this bound is an eighth of the
/// largest control vector of b″ over [0, 1].
///
/// `implementation(curve)` must give the bound in the maximum norm; `t` is a local parameter.
/// The second claim takes the second derivative, not the second differences, and refuses a bound that is too large.
///
/// # Rounding
///
/// The Bernstein sum passes 4n + 2 roundings, the chord 3, their difference one.
/// A second difference passes 2 roundings with terms of 4·max|bᵢ|, the factors 3;
/// the second derivative 4 a step and the square of the length 3.
pub fn chord_bound<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> P::Scalar,
    curve: &BezierCurve<P>,
    t: P::Scalar,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let size = largest_coordinate(curve.control_points());
    let bound = implementation(curve);
    let points = curve.control_points();
    let chord = points[0].lerp(&points[n], t.clone());
    let away = largest_difference(&bernstein_sum(points, &t), chord.coordinates());
    Sides::new(format!("t = {t}, {curve}"))
        .at_most(
            "the curve is as near to its chord as the bound says",
            [away],
            [bound.clone()],
            Rounding::new(4 * n + 16, (2.0 + 4.0 * factor(n)) * size),
        )
        .equal(
            "the bound is an eighth of the largest control vector of b″",
            [bound],
            [eighth_of_second_derivative(curve)],
            Rounding::new(24, 4.0 * factor(n) * size),
        )
}

/// Part of `bezier-chord-bound`: the distance of b(t) from the segment b₀bₙ is at most that of the worst control point.
///
/// `implementation(curve)` must give the square of the latter; `t` is a local parameter in [0, 1].
///
/// # Rounding
///
/// With S = max|bᵢ|, every difference has coordinates of at most 2S, a square of a distance at most D terms of 4S².
/// The point passes 4n + 2 roundings, the foot of the perpendicular 3D + 8, difference and square 4.
pub fn chord_segment_bound<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> P::Scalar,
    curve: &BezierCurve<P>,
    t: P::Scalar,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let points = curve.control_points();
    let sum = bernstein_sum(points, &t);
    let point = P::from_fn(|k| sum[k].clone());
    let distance = segment_distance_squared(&point, &points[0], &points[n]);
    let dimension = P::DIMENSION as f64;
    let magnitude = 16.0 * dimension * largest_coordinate(points).powi(2);
    let rounding = Rounding::new(2 * (4 * n + 2 + 3 * P::DIMENSION + 12), magnitude);
    let worst = implementation(curve);
    let reached: Vec<P::Scalar> = points
        .iter()
        .map(|point| segment_distance_squared(point, &points[0], &points[n]) - worst.clone())
        .filter(|excess| *excess >= P::Scalar::zero())
        .take(1)
        .collect();
    Sides::new(format!("t = {t}, {curve}"))
        .at_most(
            "the curve is as near to the segment as the worst control point",
            [distance],
            [worst],
            rounding,
        )
        .equal(
            "some control point is the worst",
            reached,
            [P::Scalar::zero()],
            rounding,
        )
}

/// `bezier-control-polygon-bound`: |b(t) − l(t)| ≤ N_∞(n)·‖Δ²b‖, N_∞(n) = n/8 − w/(8n), w = 1 for odd n and 0 for even.
///
/// `implementation(curve)` must give the bound in the maximum norm for n ≥ 1.
/// The parameter is t = (leg + λ)/n with 0 ≤ leg < n and 0 ≤ λ ≤ 1.
///
/// # Rounding
///
/// The Bernstein sum passes 4n + 2 roundings and its parameter 2, which move it by at most 4n·u·max|bᵢ|;
/// the polygon 3; the bound 8 with terms of 4·max|bᵢ|.
pub fn control_polygon_bound<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> P::Scalar,
    curve: &BezierCurve<P>,
    leg: usize,
    lambda: P::Scalar,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let points = curve.control_points();
    let size = largest_coordinate(points);
    let t =
        (P::Scalar::from_integer(leg as i64) + lambda.clone()) / P::Scalar::from_integer(n as i64);
    let on_polygon = points[leg].lerp(&points[leg + 1], lambda.clone());
    let away = largest_difference(&bernstein_sum(points, &t), on_polygon.coordinates());
    let bound = implementation(curve);
    let rounding = Rounding::new(8 * n + 20, (2.0 + 4.0 * n as f64 / 8.0) * size);
    Sides::new(format!("leg {leg}, λ = {lambda}, {curve}"))
        .at_most(
            "the curve is as near to its polygon as the bound says",
            [away],
            [bound.clone()],
            rounding,
        )
        .equal(
            "the bound is (n/8 − w/(8n))·‖Δ²b‖",
            [bound],
            [reif_factor::<P::Scalar>(n) * largest_second_difference(points)],
            rounding,
        )
}

/// `bezier-subdivision-second-differences`: for the halves q, r of b, 4Δ²qⱼ and 4Δ²rⱼ are points of the scheme of
/// de Casteljau of the sequence Δ²b at 1/2, so ‖Δ²q‖ and ‖Δ²r‖ are at most ‖Δ²b‖/4.
///
/// `implementation(curve)` must give both halves; n ≥ 2.
///
/// # Rounding
///
/// A control point of a half passes n roundings, a second difference 2 more with terms of 4·max|bᵢ|;
/// the Bernstein sum of second differences 4n + 4.
pub fn subdivision_second_differences<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> [BezierCurve<P>; 2],
    curve: &BezierCurve<P>,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let size = largest_coordinate(curve.control_points());
    let rounding = Rounding::new(5 * n + 8, 4.0 * size);
    let quarter = P::Scalar::from_ratio(1, 4);
    let half = P::Scalar::from_ratio(1, 2);
    let old: Vec<Vec<P::Scalar>> = coordinate_differences(curve.control_points());
    let [left, right] =
        implementation(curve).map(|piece| coordinate_differences(piece.control_points()));
    // The mean of the old second differences first … first + level, with the weights Bₗ(1/2).
    let mean = |first: usize, level: usize| {
        (0..P::DIMENSION)
            .map(|k| {
                (0..=level).fold(P::Scalar::zero(), |sum, l| {
                    sum + bernstein(level, l as i64, half.clone()) * old[first + l][k].clone()
                }) * quarter.clone()
            })
            .collect::<Vec<_>>()
    };
    let last = n.saturating_sub(2);
    let allowed = largest_of(&old) * quarter.clone();
    Sides::new(curve)
        .equal(
            "left: 4Δ²qⱼ is the first point of level j",
            left.concat(),
            (0..=last).flat_map(|j| mean(0, j)),
            rounding,
        )
        .equal(
            "right: 4Δ²rⱼ is the last point of level n − 2 − j",
            right.concat(),
            (0..=last).flat_map(|j| mean(j, last - j)),
            rounding,
        )
        .at_most(
            "both are at most a quarter",
            [largest_of(&left), largest_of(&right)],
            [allowed.clone(), allowed],
            rounding,
        )
}

/// `bezier-subdivision-depth`: k halvings make every chord accurate to ε, and k is the least number for which
/// the chord bound says so.
///
/// `implementation(curve, ε)` must give k. Piece `seed` mod 2ᵏ is tried at its local parameter `t`.
///
/// # Rounding
///
/// As for [`chord_bound`]; the ends of a piece pass 4n + 2 roundings each.
pub fn subdivision_depth<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, &P::Scalar) -> usize,
    curve: &BezierCurve<P>,
    tolerance: P::Scalar,
    seed: usize,
    t: P::Scalar,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let points = curve.control_points();
    let size = largest_coordinate(points);
    let steps = implementation(curve, &tolerance);
    let bound = eighth_of_second_derivative(curve);
    let quartered = |bound: &P::Scalar, times: usize| {
        bound.clone() * dyadic::<P::Scalar>(1, times) * dyadic(1, times)
    };
    let rounding = Rounding::new(24, 4.0 * factor(n) * size);
    let mut sides = Sides::new(format!("ε = {tolerance}, k = {steps}, {curve}")).at_most(
        "k halvings are enough",
        [quartered(&bound, steps)],
        [tolerance.clone()],
        rounding,
    );
    if steps > 0 {
        sides = sides.at_most(
            "k − 1 halvings are not",
            [tolerance.clone()],
            [quartered(&bound, steps - 1)],
            rounding,
        );
    }
    // Beyond 2³⁰ pieces only the first ones are tried: their ends are still exact in `f64`.
    let piece = seed % (1 << steps.min(30));
    let [start, end]: [P::Scalar; 2] = [dyadic(piece, steps), dyadic(piece + 1, steps)];
    let parameter = start.clone() * (P::Scalar::one() - t.clone()) + end.clone() * t.clone();
    let from = bernstein_sum(points, &start);
    let to = bernstein_sum(points, &end);
    let chord: Vec<P::Scalar> = std::iter::zip(from, to)
        .map(|(a, b)| a.lerp(&b, t.clone()))
        .collect();
    let away = largest_difference(&bernstein_sum(points, &parameter), &chord);
    sides.at_most(
        format!("piece {piece} is within ε of its chord"),
        [away],
        [tolerance],
        Rounding::new(16 * n + 32, (2.0 + 4.0 * factor(n)) * size),
    )
}

/// `bezier-uniform-convergence`: |Pₖ(u) − b(u)| ≤ N_∞(n)·‖Δ²b‖/4ᵏ for all u in [0, 1].
///
/// `implementation(curve, k)` must give the n·2ᵏ + 1 vertices of Pₖ, which stand at equal distances over [0, 1].
/// The leg number `seed` mod n·2ᵏ is tried at λ; n ≥ 1.
///
/// # Rounding
///
/// A vertex passes kn roundings, the Bernstein sum 4n + 2 and its parameter 2 (4n more), the bound 8.
pub fn uniform_convergence<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, usize) -> Vec<P>,
    curve: &BezierCurve<P>,
    steps: usize,
    seed: usize,
    lambda: P::Scalar,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let points = curve.control_points();
    let size = largest_coordinate(points);
    let vertices = implementation(curve, steps);
    let legs = n << steps;
    let sides = Sides::new(format!("k = {steps}, λ = {lambda}, {curve}")).equal(
        "there are n·2ᵏ + 1 vertices",
        [P::Scalar::from_integer(vertices.len() as i64)],
        [P::Scalar::from_integer(legs as i64 + 1)],
        Rounding::none(),
    );
    if vertices.len() != legs + 1 {
        return sides;
    }
    let leg = seed % legs;
    let u = (P::Scalar::from_integer(leg as i64) + lambda.clone())
        / P::Scalar::from_integer(legs as i64);
    let on_polygon = vertices[leg].lerp(&vertices[leg + 1], lambda);
    let away = largest_difference(&bernstein_sum(points, &u), on_polygon.coordinates());
    let quartered = dyadic::<P::Scalar>(1, 2 * steps);
    let bound = reif_factor::<P::Scalar>(n) * largest_second_difference(points) * quartered;
    sides.at_most(
        format!("leg {leg} is as near to the curve as the bound says"),
        [away],
        [bound],
        Rounding::new((steps + 8) * n + 20, (2.0 + 4.0 * n as f64 / 8.0) * size),
    )
}

/// n(n − 1)/8.
fn factor(degree: usize) -> f64 {
    (degree * degree.saturating_sub(1)) as f64 / 8.0
}

/// n/8 − w/(8n).
fn reif_factor<T: Scalar>(degree: usize) -> T {
    let n = degree as i64;
    T::from_ratio(n, 8) - T::from_ratio(n % 2, 8 * n.max(1))
}

/// An eighth of the largest control vector of the second derivative with respect to the local parameter.
fn eighth_of_second_derivative<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let length = curve.domain().length();
    let second = curve.derivative().derivative();
    let largest = second
        .control_points()
        .iter()
        .map(maximum_norm)
        .fold(P::Scalar::zero(), OrderedScalar::max);
    largest * length.clone() * length / P::Scalar::from_integer(8)
}

/// bₖ₊₂ − 2bₖ₊₁ + bₖ, coordinate by coordinate.
fn coordinate_differences<P: Affine>(points: &[P]) -> Vec<Vec<P::Scalar>> {
    let two = P::Scalar::from_integer(2);
    points
        .windows(3)
        .map(|p| {
            (0..P::DIMENSION)
                .map(|k| {
                    let [first, second, third] = [0, 1, 2].map(|i| p[i].coordinates()[k].clone());
                    third - two.clone() * second + first
                })
                .collect()
        })
        .collect()
}

fn largest_of<T: OrderedScalar>(vectors: &[Vec<T>]) -> T {
    vectors
        .iter()
        .flatten()
        .fold(T::zero(), |largest, x| largest.max(x.abs()))
}

fn largest_second_difference<P: Affine>(points: &[P]) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    largest_of(&coordinate_differences(points))
}

/// The distance of two points in the maximum norm.
fn largest_difference<T: OrderedScalar>(left: &[T], right: &[T]) -> T {
    std::iter::zip(left, right).fold(T::zero(), |largest, (a, b)| {
        largest.max((a.clone() - b.clone()).abs())
    })
}
