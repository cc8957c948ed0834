//! Laws of subdivision and corner cutting.

use num_traits::{One, Zero};

use super::{flat, largest_coordinate};
use crate::affine::Affine;
use crate::bezier::bounds::maximum_norm;
use crate::bezier::subdivision::dyadic;
use crate::bezier::{BezierCurve, bernstein};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// `bezier-bernstein-scaling`: Bᵢⁿ(αt) = Σⱼ Bᵢʲ(α)·Bⱼⁿ(t), i = 0 … n, for all numbers α and t.
///
/// `implementation(n, i, t)` must give Bᵢⁿ(t), and 0 for i > n.
///
/// # Rounding
///
/// Let A = |α| + |1 − α| and M = (|1 − t| + A|t|)ⁿ.
/// A product Bᵢʲ(α)·Bⱼⁿ(t) passes 3j + 1, 3n + 1 and one roundings, the sum n more: 7n + 3 on the right.
/// On the left 3n + 1, and the rounding of αt, which moves αt and 1 − αt by at most u(|αt| + |1 − αt|) each:
/// 2n more. The terms of each side sum to at most M, because |1 − αt| ≤ |1 − t| + |t||1 − α|.
pub fn bernstein_scaling<T: Scalar>(
    implementation: impl Fn(usize, i64, T) -> T,
    degree: usize,
    alpha: T,
    t: T,
) -> Sides<T> {
    let n = degree;
    let magnitude =
        ((T::one() - t.clone()).magnitude() + spread(&alpha) * t.magnitude()).powi(n as i32);
    let indices = 0..=n as i64;
    let left = indices
        .clone()
        .map(|i| implementation(n, i, alpha.clone() * t.clone()));
    let of_t: Vec<T> = indices
        .clone()
        .map(|j| implementation(n, j, t.clone()))
        .collect();
    let right = indices.map(|i| {
        of_t.iter().enumerate().fold(T::zero(), |sum, (j, weight)| {
            sum + implementation(j, i, alpha.clone()) * weight.clone()
        })
    });
    Sides::new(format!("n = {n}, α = {alpha}, t = {t}")).equal(
        "B(αt) is the sum of B(α)·B(t)",
        left,
        right,
        Rounding::new(12 * n + 4, magnitude),
    )
}

/// `bezier-subdivision`: the pieces are b(αt) and b((1 − α)t + α), and they meet in b(α).
///
/// `implementation(curve, α)` must give both pieces over [0, 1], α and t local parameters, any numbers.
/// The curve is evaluated by its Bernstein sum.
///
/// # Rounding
///
/// Let A = |α| + |1 − α|, B = |t| + |1 − t| and M = max|bᵢ|·(AB)ⁿ.
/// A control point of a piece passes 3n roundings, its value 3n more.
/// The sum passes 4n + 2; its parameter v = (1 − α)t + α has an error of at most 4u·AB, 1 − v one more,
/// and |v| + |1 − v| ≤ AB, so that the sum moves by at most 10n·u·M. Together 20n + 2.
pub fn subdivision<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> [BezierCurve<P>; 2],
    curve: &BezierCurve<P>,
    alpha: P::Scalar,
    t: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let points = curve.control_points();
    let [left, right] = implementation(curve, alpha.clone());
    let one = P::Scalar::one();
    let magnitude = largest_coordinate(points) * (spread(&alpha) * spread(&t)).powi(n as i32);
    let rounding = Rounding::new(20 * n + 2, magnitude);
    let beyond = (one - alpha.clone()) * t.clone() + alpha.clone();
    let end = left.control_points().last();
    let start = right.control_points().first();
    Sides::new(format!("α = {alpha}, t = {t}, {curve}"))
        .equal(
            "the left piece is b(αt)",
            flat([&left.at(t.clone())]),
            bernstein_sum(points, &(alpha.clone() * t.clone())),
            rounding,
        )
        .equal(
            "the right piece is b((1 − α)t + α)",
            flat([&right.at(t)]),
            bernstein_sum(points, &beyond),
            rounding,
        )
        .equal("the pieces meet", flat(end), flat(start), Rounding::none())
        .equal(
            "they meet in b(α)",
            flat(end),
            bernstein_sum(points, &alpha),
            rounding,
        )
}

/// `bezier-corner-cutting-convergence`: Pₖ has n·2ᵏ + 1 vertices, those number j·n are the curve points b(j/2ᵏ),
/// every leg is at most d/2ᵏ long, and every vertex is at most ⌊n/2⌋·d/2ᵏ away from one of those points.
///
/// `implementation(curve, k)` must give the vertices of Pₖ; d is the longest leg of P₀ in the maximum norm.
///
/// # Rounding
///
/// A vertex passes kn roundings, a leg 2 more; the Bernstein sum 4n + 2. Differences have terms of twice max|bᵢ|.
pub fn corner_cutting_convergence<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, usize) -> Vec<P>,
    curve: &BezierCurve<P>,
    steps: usize,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let points = curve.control_points();
    let vertices = implementation(curve, steps);
    let pieces = 1usize << steps;
    let magnitude = 2.0 * largest_coordinate(points);
    let rounding = Rounding::new(2 * n * steps + 4 * n + 6, magnitude);
    let distance = |a: &P, b: &P| maximum_norm(&a.difference(b));
    let longest = points
        .windows(2)
        .map(|leg| distance(&leg[1], &leg[0]))
        .fold(P::Scalar::zero(), OrderedScalar::max);
    let shortened = longest * dyadic::<P::Scalar>(1, steps);
    let legs: Vec<P::Scalar> = vertices
        .windows(2)
        .map(|leg| distance(&leg[1], &leg[0]))
        .collect();
    let count = P::Scalar::from_integer(vertices.len() as i64);
    let expected = P::Scalar::from_integer((n * pieces + 1) as i64);
    let mut sides = Sides::new(format!("k = {steps}, {curve}")).equal(
        "there are n·2ᵏ + 1 vertices",
        [count],
        [expected],
        Rounding::none(),
    );
    if vertices.len() != n * pieces + 1 {
        return sides;
    }
    let on_curve = |j: usize| {
        P::from_fn({
            let point = bernstein_sum(points, &dyadic(j, steps));
            move |coordinate| point[coordinate].clone()
        })
    };
    let ends: Vec<P> = (0..=pieces).map(on_curve).collect();
    if n > 0 {
        sides = sides.equal(
            "the pieces end on the curve",
            flat(vertices.iter().step_by(n)),
            flat(&ends),
            rounding,
        );
    }
    let allowed = vec![shortened.clone(); legs.len()];
    sides = sides.at_most("a leg is at most d/2ᵏ long", legs, allowed, rounding);
    let away = vertices.iter().enumerate().map(|(i, vertex)| {
        let nearest = (i + n / 2).checked_div(n).unwrap_or(0);
        distance(vertex, &ends[nearest])
    });
    let radius = P::Scalar::from_integer((n / 2) as i64) * shortened;
    let radii = vec![radius; vertices.len()];
    sides.at_most(
        "a vertex is at most ⌊n/2⌋·d/2ᵏ away from the curve",
        away.collect::<Vec<_>>(),
        radii,
        rounding,
    )
}

/// The coordinates of Σ Bᵢⁿ(t)·bᵢ: another way to the curve point than the algorithm of de Casteljau.
pub(super) fn bernstein_sum<P: Affine>(points: &[P], t: &P::Scalar) -> Vec<P::Scalar> {
    let degree = points.len() - 1;
    let weights: Vec<P::Scalar> = (0..=degree)
        .map(|i| bernstein(degree, i as i64, t.clone()))
        .collect();
    (0..P::DIMENSION)
        .map(|k| {
            std::iter::zip(&weights, points).fold(P::Scalar::zero(), |sum, (weight, point)| {
                sum + weight.clone() * point.coordinates()[k].clone()
            })
        })
        .collect()
}

/// |t| + |1 − t|: by how much one step of the scheme can enlarge; 1 inside the domain.
fn spread<T: Scalar>(t: &T) -> f64 {
    t.magnitude() + (T::one() - t.clone()).magnitude()
}
