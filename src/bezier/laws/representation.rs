//! Laws of the Bernstein form.

use num_traits::Zero;

use super::{flat, magnitude};
use crate::affine::Affine;
use crate::bezier::{BezierCurve, CasteljauTriangle, bernstein};
use crate::law::{Rounding, Sides};

/// `bezier-intermediate-points`: bᵢʲ(t) = Σₗ Bₗʲ(t)·bᵢ₊ₗ for 0 ≤ j ≤ n, 0 ≤ i ≤ n − j.
///
/// `implementation(curve, u)` must give the whole scheme of de Casteljau.
///
/// # Rounding
///
/// A term of the scheme passes three roundings a level (1 − t, product, sum), 3n in all.
/// A term of the sum passes 3n + 1 for the Bernstein polynomial, one for the product and n for the
/// sum. Together 7n + 2.
pub fn intermediate_points<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> CasteljauTriangle<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let triangle = implementation(curve, u.clone());
    let t = curve.domain().local(u.clone());
    let n = curve.degree();
    let rounding = Rounding::new(7 * n + 2, magnitude(curve, &u));
    let mut sides = Sides::new(format!("u = {u}, {curve}"));
    for j in 0..=n {
        let weights: Vec<P::Scalar> = (0..=j).map(|l| bernstein(j, l as i64, t.clone())).collect();
        let sums = curve.control_points().windows(j + 1).flat_map(|points| {
            (0..P::DIMENSION)
                .map(|k| weighted_sum(&weights, points, k))
                .collect::<Vec<_>>()
        });
        sides = sides.equal(
            format!("the points of level {j} are Bernstein sums of degree {j}"),
            flat(triangle.column(j)),
            sums,
            rounding,
        );
    }
    sides
}

/// `bezier-bernstein-representation`: b(u) = Σₗ Bₗⁿ(t)·bₗ, l = 0 … n.
///
/// `implementation(curve, u)` must give the curve point.
///
/// # Rounding
///
/// A term of the implementation passes at most 3n roundings in the scheme of de Casteljau.
/// In Horner's scheme it passes n for the powers of t and of 1 − t, n − 1 for the last power, 2n for
/// n steps, n for the binomial coefficient and 2 products: 5n + 1.
/// A term of the sum passes 3n + 1 for the Bernstein polynomial, one for the product and n for the
/// sum. Together 9n + 3.
pub fn bernstein_representation<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> P,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let point = implementation(curve, u.clone());
    let t = curve.domain().local(u.clone());
    let n = curve.degree();
    let weights: Vec<P::Scalar> = (0..=n).map(|l| bernstein(n, l as i64, t.clone())).collect();
    let sum = (0..P::DIMENSION).map(|k| weighted_sum(&weights, curve.control_points(), k));
    Sides::new(format!("u = {u}, {curve}")).equal(
        "the point is the Bernstein sum of the control points",
        flat([&point]),
        sum,
        Rounding::new(9 * n + 3, magnitude(curve, &u)),
    )
}

/// The linear evaluation agrees with the algorithm of de Casteljau, also where C(n, i) and tⁿ are
/// beyond the range of `f64`.
///
/// `implementation(curve, u)` must give the curve point.
///
/// # Rounding
///
/// De Casteljau: 3n. Horner's scheme: 5n + 1, see [`bernstein_representation`].
///
/// The geometric scheme: let ĥₖ and ĝₖ be the computed weights of step k, and let w₀ = 1,
/// wₖ/(w₀ + … + wₖ₋₁) = ĥₖ/ĝₖ define the weights that it uses in effect.
/// Then wₖ/wₖ₋₁ is t·(n − k + 1)/((1 − t)·k) up to 8 roundings: two each for A and for k·(1 − t), two
/// quotients, and two by which ĥₖ₋₁ + ĝₖ₋₁ misses 1.
/// So wₗ/(w₀ + … + wₙ) is Bₗⁿ(t) up to 16n roundings. The product ĥₗ·ĝₗ₊₁⋯ĝₙ misses this quotient
/// by 2n, and the products and sums of points add 2n. Together 20n, and 23n with de Casteljau.
pub fn linear_evaluation<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> P,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let roundings = (23 * curve.degree()).max(1);
    Sides::new(format!("u = {u}, {curve}")).equal(
        "the point is that of the algorithm of de Casteljau",
        flat([&implementation(curve, u.clone())]),
        flat([&curve.at(u.clone())]),
        Rounding::new(roundings, magnitude(curve, &u)),
    )
}

/// Coordinate k of the sum of the points with these weights.
fn weighted_sum<P: Affine>(weights: &[P::Scalar], points: &[P], k: usize) -> P::Scalar {
    std::iter::zip(weights, points).fold(P::Scalar::zero(), |sum, (weight, point)| {
        sum + weight.clone() * point.coordinates()[k].clone()
    })
}
