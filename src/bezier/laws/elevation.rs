//! Laws of degree elevation and of Bernstein approximation.

use num_traits::Zero;

use super::{flat, largest_coordinate, magnitude};
use crate::affine::Affine;
use crate::bezier::{BezierCurve, bernstein, polygon_at};
use crate::law::{Rounding, Sides};

/// `bezier-degree-elevation`: the elevated polygon, one point longer, has the same curve.
///
/// `implementation(curve)` must elevate the degree by one. The elevated curve is evaluated as a sum
/// of Bernstein polynomials, the given one by de Casteljau.
///
/// # Rounding
///
/// An elevated point passes 4 roundings (quotient, 1 − quotient, product, sum), its term in the sum
/// 3(n + 1) + 1 for the Bernstein polynomial, 1 for the product and n + 1 for the sum; de Casteljau
/// 3n. Together 7n + 10. The terms of degree n + 1 are bounded by those of the elevated curve.
pub fn degree_elevation<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> BezierCurve<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let elevated = implementation(curve);
    let n = curve.degree();
    let rounding = Rounding::new(
        7 * n + 10,
        magnitude(&elevated, &u).max(magnitude(curve, &u)),
    );
    Sides::new(format!("u = {u}, {curve}"))
        .equal(
            "the degree is one higher and the ends stay",
            ends(n + 1, elevated.degree(), &elevated),
            ends(n + 1, n + 1, curve),
            Rounding::none(),
        )
        .equal(
            "the elevated polygon has the same curve",
            bernstein_sum(&elevated, &u),
            curve.at(u).coordinates().to_vec(),
            rounding,
        )
}

/// The end points, if the degree is the expected one; else nothing.
fn ends<P: Affine>(expected: usize, found: usize, curve: &BezierCurve<P>) -> Vec<P::Scalar> {
    if expected == found {
        let points = curve.control_points();
        flat([&points[0], &points[points.len() - 1]])
    } else {
        Vec::new()
    }
}

fn bernstein_sum<P: Affine>(curve: &BezierCurve<P>, u: &P::Scalar) -> Vec<P::Scalar> {
    let t = curve.domain().local(u.clone());
    let n = curve.degree();
    let mut sum = vec![P::Scalar::zero(); P::DIMENSION];
    for (i, point) in curve.control_points().iter().enumerate() {
        let weight = bernstein(n, i as i64, t.clone());
        for (total, coordinate) in sum.iter_mut().zip(point.coordinates()) {
            *total += weight.clone() * coordinate.clone();
        }
    }
    sum
}

/// `bezier-bernstein-approximation`: the Bernstein approximation of the control polygon is the curve.
///
/// `implementation(polygon, m)` must give the Bernstein approximation of degree m of the function
/// `polygon` on [0, 1]. It is asked for that of the polygon of `vertices`, and must give back the
/// Bézier curve of these vertices, which is evaluated as a sum of Bernstein polynomials.
///
/// # Rounding
///
/// The parameter m·(i/m) misses i by two roundings of a number up to m, so the point of the polygon
/// misses the vertex by 2u·m legs, each at most twice the largest coordinate; interpolation adds 3.
/// That is 7 roundings of m times the largest coordinate. Evaluation adds 3m + (4m + 2) as in
/// `intermediate_points`.
pub fn bernstein_approximation<P>(
    implementation: impl Fn(&dyn Fn(P::Scalar) -> P, usize) -> BezierCurve<P>,
    vertices: &[P],
    t: P::Scalar,
) -> Sides<P::Scalar>
where
    P: Affine,
    P::Scalar: PartialOrd,
{
    let degree = vertices.len() - 1;
    let curve = BezierCurve::trusted(crate::affine::Interval::unit(), vertices.to_vec());
    let approximation = implementation(&|t| polygon_at(vertices, t), degree);
    let terms = magnitude(&curve, &t).max(largest_coordinate(vertices));
    Sides::new(format!("t = {t}, {curve}")).equal(
        "the Bernstein approximation of the control polygon is the Bézier curve",
        approximation.at(t.clone()).coordinates().to_vec(),
        bernstein_sum(&curve, &t),
        Rounding::new(7 * degree + 9, (degree.max(1) as f64) * terms),
    )
}
