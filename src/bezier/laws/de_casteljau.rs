//! Laws of the algorithm of de Casteljau.

use num_traits::One;

use super::{flat, magnitude};
use crate::affine::Affine;
use crate::bezier::{BezierCurve, CasteljauTriangle};
use crate::law::{Rounding, Sides};

/// `bezier-de-casteljau`: bᵢ⁰ = bᵢ and bᵢʲ = (1 − t)·bᵢʲ⁻¹ + t·bᵢ₊₁ʲ⁻¹, column by column.
///
/// `implementation(curve, u)` must give the whole scheme.
///
/// # Rounding
///
/// The right side is computed from the columns of the left, so the sides differ by one step only:
/// two products, a sum and 1 − t, on each side.
pub fn de_casteljau<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> CasteljauTriangle<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let triangle = implementation(curve, u.clone());
    let t = curve.domain().local(u.clone());
    let s = P::Scalar::one() - t.clone();
    let rounding = Rounding::new(6, 2.0 * magnitude(curve, &u));
    let mut sides = Sides::new(format!("u = {u}, {curve}")).equal(
        "the first column holds the control points",
        flat(triangle.column(0)),
        flat(curve.control_points()),
        Rounding::none(),
    );
    for level in 1..=curve.degree() {
        let expected = triangle.column(level - 1).windows(2).flat_map(|pair| {
            let (upper, lower) = (pair[0].coordinates(), pair[1].coordinates());
            std::iter::zip(upper.to_vec(), lower.to_vec())
                .map(|(upper, lower)| s.clone() * upper + t.clone() * lower)
                .collect::<Vec<_>>()
        });
        sides = sides.equal(
            format!("column {level} combines its neighbours with weights 1 − t and t"),
            flat(triangle.column(level)),
            expected,
            rounding,
        );
    }
    sides
}
