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
                .map(|k| {
                    std::iter::zip(&weights, points).fold(
                        P::Scalar::zero(),
                        |sum, (weight, point)| {
                            sum + weight.clone() * point.coordinates()[k].clone()
                        },
                    )
                })
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
