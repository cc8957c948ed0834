//! Laws of integrals.

use num_traits::Zero;

use crate::affine::{Affine, Linear};
use crate::bezier::laws::{flat, largest_coordinate};
use crate::bezier::{BezierCurve, binomial};
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `bezier-integral`: ∫ₐᵇ b(u) du = (b − a)/(m + 1)·(b₀ + … + bₘ).
///
/// `implementation(curve)` must give the integral of a curve of vectors or numbers. It is compared
/// with the integral of the power form, Bᵢᵐ = C(m, i)·Σₖ (−1)ᵏ·C(m − i, k)·tⁱ⁺ᵏ.
/// On the unit control values the law says that every Bernstein polynomial has the integral (b − a)/(m + 1).
///
/// # Rounding
///
/// A term of the power form passes 4 roundings in its coefficient, m in the sum over k, m + 1 in that over i, 2 with
/// b − a; one of the mean m + 4. With 1/(i + k + 1) ≤ 1 the terms sum to at most Σᵢ C(m, i)·2ᵐ⁻ⁱ = 3ᵐ.
pub fn integral<V: Linear>(
    implementation: impl Fn(&BezierCurve<V>) -> V,
    curve: &BezierCurve<V>,
) -> Sides<V::Scalar> {
    let m = curve.degree();
    let length = curve.domain().length();
    let mut sum = vec![V::Scalar::zero(); V::DIMENSION];
    for (i, vector) in curve.control_points().iter().enumerate() {
        let powers = (0..=m - i).fold(V::Scalar::zero(), |sum, k| {
            let term = binomial::<V::Scalar>(m, i as i64) * binomial(m - i, k as i64)
                / V::Scalar::from_integer((i + k + 1) as i64);
            if k % 2 == 0 { sum + term } else { sum - term }
        });
        for (total, coordinate) in sum.iter_mut().zip(vector.coordinates()) {
            *total += powers.clone() * coordinate.clone();
        }
    }
    let magnitude =
        length.magnitude() * 3f64.powi(m as i32) * largest_coordinate(curve.control_points());
    Sides::new(curve).equal(
        "the integral of the power form is (b − a)/(m + 1) times the sum of the control points",
        implementation(curve).coordinates().to_vec(),
        sum.into_iter().map(|total| total * length.clone()),
        Rounding::new(3 * m + 11, magnitude),
    )
}

/// The converse of `bezier-derivative-consequences`: a curve is the antiderivative of its hodograph that
/// starts at its first control point.
///
/// `implementation(hodograph, start)` must give that antiderivative.
///
/// # Rounding
///
/// A control vector passes 4 roundings, its share (b − a)/n of it 4 more, and the sum one for each of n legs.
/// The legs are at most twice the largest coordinate each.
pub fn antiderivative<P: Affine>(
    implementation: impl Fn(&BezierCurve<P::Difference>, P) -> BezierCurve<P>,
    curve: &BezierCurve<P>,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let start = &curve.control_points()[0];
    let magnitude = (2 * n + 1) as f64 * largest_coordinate(curve.control_points());
    let found = implementation(&curve.derivative(), start.clone());
    let mut expected = flat(curve.control_points());
    if n == 0 {
        // The zero vector as a hodograph of degree 0 has an antiderivative of degree 1.
        expected.extend(start.coordinates().to_vec());
    }
    Sides::new(curve).equal(
        "integrating the hodograph gives the curve back",
        flat(found.control_points()),
        expected,
        Rounding::new(n + 9, magnitude),
    )
}
