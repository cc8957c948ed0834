//! The curve as a sum of Bernstein polynomials, and what the scheme of de Casteljau has to do with it.

use num_traits::pow;

use super::weighted_sum;
use crate::affine::{Affine, Interval};
use crate::bezier::laws::{flat, magnitude};
use crate::bezier::{
    BezierCurve, CasteljauTriangle, TrianglePath, bernstein, bernstein_basis as all_values,
    binomial,
};
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

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

/// `bezier-basis-function-from-de-casteljau`: with the control values 1 at index k and 0 elsewhere, the
/// scheme of de Casteljau ends in B_kⁿ(t), and the two values before are B_kⁿ⁻¹(t) and B_{k−1}ⁿ⁻¹(t).
///
/// `implementation(curve, t)` must give the whole scheme of a curve of numbers over [0, 1].
///
/// # Rounding
///
/// 3n in the scheme and 3n + 1 for the Bernstein polynomial.
pub fn basis_function_from_de_casteljau<T: Scalar>(
    implementation: impl Fn(&BezierCurve<T>, T) -> CasteljauTriangle<T>,
    n: usize,
    k: usize,
    t: T,
) -> Sides<T> {
    let values = (0..=n)
        .map(|i| T::from_integer(i64::from(i == k)))
        .collect();
    let curve = BezierCurve::trusted(Interval::unit(), values);
    let triangle = implementation(&curve, t.clone());
    let index = k as i64;
    let rounding = Rounding::new(6 * n + 1, magnitude(&curve, &t));
    let sides = Sides::new(format!("n = {n}, k = {k}, t = {t}")).equal(
        "the tip is B_k of degree n",
        [triangle.tip().clone()],
        [bernstein(n, index, t.clone())],
        rounding,
    );
    if n == 0 {
        return sides;
    }
    sides.equal(
        "the values before the tip are B_k and B_{k−1} of degree n − 1",
        triangle.column(n - 1).iter().cloned(),
        [
            bernstein(n - 1, index, t.clone()),
            bernstein(n - 1, index - 1, t),
        ],
        rounding,
    )
}

/// `bezier-de-casteljau-path-counting`: C(n, k) paths lead from b_k to the tip; each steps up k times
/// and has the weight tᵏ·(1 − t)ⁿ⁻ᵏ; together they weigh B_kⁿ(t).
///
/// `implementation(n, k)` must give the paths.
///
/// # Rounding
///
/// A weight is a product of n factors, each with the rounding of 1 − t: 2n. A power has as many.
/// The sum of C(n, k) weights adds as many roundings, the Bernstein polynomial 3n + 1.
pub fn de_casteljau_path_counting<T: Scalar>(
    implementation: impl Fn(usize, usize) -> Vec<TrianglePath>,
    n: usize,
    k: usize,
    t: T,
) -> Sides<T> {
    let paths = implementation(n, k);
    let s = T::one() - t.clone();
    let count = |number: usize| T::from_integer(number as i64);
    let distinct: std::collections::HashSet<&TrianglePath> = paths.iter().collect();
    let weights: Vec<T> = paths.iter().map(|path| path.weight(t.clone())).collect();
    let one_path = pow(t.clone(), k) * pow(s.clone(), n - k.min(n));
    let size = (t.magnitude() + s.magnitude()).powi(n as i32);
    let sum = weights
        .iter()
        .fold(T::zero(), |sum, weight| sum + weight.clone());
    let ends = paths.iter().map(|path| path.points().last().copied());
    Sides::new(format!("n = {n}, k = {k}, t = {t}"))
        .equal(
            "there are C(n, k) paths, all different",
            [count(paths.len()), count(distinct.len())],
            [binomial(n, k as i64), binomial(n, k as i64)],
            Rounding::new(n, libm::exp2(n as f64)),
        )
        .equal(
            "each path leads from the control point of index k to the tip",
            paths.iter().zip(ends).flat_map(|(path, end)| {
                let (level, index) = end.unwrap_or((0, 0));
                [count(path.start()), count(level), count(index)]
            }),
            paths.iter().flat_map(|_| [count(k), count(n), count(0)]),
            Rounding::none(),
        )
        .equal(
            "each path has k factors t and n − k factors 1 − t",
            weights.iter().cloned(),
            vec![one_path; weights.len()],
            Rounding::new(4 * n, size),
        )
        .equal(
            "the weights of all paths sum to the Bernstein polynomial",
            [sum],
            [bernstein(n, k as i64, t)],
            Rounding::new(5 * n + 1 + paths.len(), size),
        )
}

/// `bezier-de-casteljau-derivation`: b(t) = Σᵢ bᵢʳ·Bᵢⁿ⁻ʳ(t), i = 0 … n − r, for every r from 0 to n.
///
/// (The slides count the points of column r from i = r on; here they start at 0.)
/// `implementation(curve, u)` must give the whole scheme of de Casteljau.
///
/// # Rounding
///
/// In column r a term passes 3r roundings in the scheme, 3(n − r) + 1 in the Bernstein polynomial, one
/// product and n − r sums, at most 4n + 2; the column 0 on the other side as many.
pub fn de_casteljau_derivation<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> CasteljauTriangle<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let triangle = implementation(curve, u.clone());
    let t = curve.domain().local(u.clone());
    let n = curve.degree();
    let rounding = Rounding::new(8 * n + 4, magnitude(curve, &u));
    let sum = |points: &[P]| -> Vec<P::Scalar> {
        let weights = all_values(points.len() - 1, t.clone());
        (0..P::DIMENSION)
            .map(|k| weighted_sum(&weights, points, k))
            .collect()
    };
    let whole = sum(curve.control_points());
    (0..=n).fold(Sides::new(format!("u = {u}, {curve}")), |sides, r| {
        sides.equal(
            format!("column {r} has the curve point as its Bernstein sum"),
            sum(triangle.column(r)),
            whole.clone(),
            rounding,
        )
    })
}
