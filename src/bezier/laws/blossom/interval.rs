//! Laws of curves over arbitrary intervals; roundings are counted as for blossoms.

use num_traits::{One, Zero};

use super::super::{largest_coordinate, magnitude};
use super::{
    LEVEL, bernstein_roundings, bernstein_row, bernstein_sum, binomials, difference_weights,
    powers, spread, weighted_sum,
};
use crate::affine::{Affine, Interval};
use crate::bezier::BezierCurve;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `bezier-arbitrary-interval`: over [a, b] the trace is the same, and the p-th derivative has the factor (b − a)⁻ᵖ.
///
/// `implementation(curve, u)` must give the point and the derivatives of order 1 to n. The point is compared
/// with Σ bᵢ·Bᵢⁿ(t), and with that of the same control points over [0, 1], at t = (u − a)/(b − a); the derivatives with
/// n!/(n − p)!·(b − a)⁻ᵖ·Σ Δᵖbᵢ·Bᵢⁿ⁻ᵖ(t).
///
/// # Rounding
///
/// Points as in the head of this file. A derivative of order p on the left: for every order a difference, the
/// factor n/(b − a) (two) and a product, then 9(n − p). On the right: Δᵖ p + 1, the factor 3p,
/// a product, and 11(n − p) + 2. Together at most 20n + 12. The terms are at most
/// max|bᵢ|·n!/(n − p)!·2ᵖ·|b − a|⁻ᵖ·Lⁿ⁻ᵖ.
pub fn arbitrary_interval<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> (P, Vec<P::Difference>),
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let domain = curve.domain();
    let t = domain.local(u.clone());
    let (point, derivatives) = implementation(curve, u.clone());
    let on_unit_interval = curve.reparametrised(Interval::unit());
    let mut sides = Sides::new(format!("u = {u}, {curve}"))
        .equal(
            "the sum of Bernstein polynomials at the local parameter",
            point.coordinates().to_vec(),
            bernstein_sum(curve.control_points(), &t),
            Rounding::new(LEVEL * n + bernstein_roundings(n), magnitude(curve, &u)),
        )
        .equal(
            "the same trace as over [0, 1]",
            point.coordinates().to_vec(),
            on_unit_interval.at(t.clone()).coordinates().to_vec(),
            Rounding::new(2 * LEVEL * n, magnitude(curve, &u)),
        )
        .equal(
            "derivatives of order 1 to n",
            [P::Scalar::from_integer(derivatives.len() as i64)],
            [P::Scalar::from_integer(n as i64)],
            Rounding::none(),
        );
    let mut factor = P::Scalar::one();
    for (p, derivative) in (1..=n).zip(&derivatives) {
        factor = factor * P::Scalar::from_integer((n - p + 1) as i64) / domain.length();
        let mut expected = vec![P::Scalar::zero(); P::DIMENSION];
        let signed = difference_weights::<P::Scalar>(p);
        let differences = curve
            .control_points()
            .windows(p + 1)
            .map(|points| weighted_sum(std::iter::zip(signed.iter().cloned(), points)));
        for (weight, difference) in std::iter::zip(bernstein_row(n - p, &t), differences) {
            for (total, difference) in expected.iter_mut().zip(difference) {
                *total += weight.clone() * difference;
            }
        }
        for coordinate in &mut expected {
            *coordinate *= factor.clone();
        }
        let terms = largest_coordinate(curve.control_points())
            * factor.magnitude()
            * 2_f64.powi(p as i32)
            * spread(&t).powi((n - p) as i32);
        sides = sides.equal(
            format!("the derivative of order {p}"),
            derivative.coordinates().to_vec(),
            expected,
            Rounding::new(20 * n + 12, terms),
        );
    }
    sides
}

/// `bezier-segment`: X(u) = (b − a)⁻ⁿ·Σ bᵢ·C(n, i)·(u − a)ⁱ·(b − u)ⁿ⁻ⁱ.
///
/// `implementation(curve, u)` must give the point of the segment.
///
/// # Rounding
///
/// On the left 9n. On the right n for u − a and b − u, 4n for the powers and the binomial
/// coefficient, 1 for the product, n for the sum, and 2n + 1 for the division: 8n + 2. The numbers u − a and
/// b − u have relative errors of one rounding, so the terms are max|bᵢ|·Lⁿ.
pub fn segment<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> P,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let n = curve.degree();
    let domain = curve.domain();
    let after = u.clone() - domain.start();
    let before = domain.end() - u.clone();
    let weights = std::iter::zip(powers(n, &after), powers(n, &before).into_iter().rev())
        .zip(binomials::<P::Scalar>(n))
        .map(|((after, before), binomial)| binomial * (after * before));
    let sum = weighted_sum(std::iter::zip(weights, curve.control_points()));
    let length = num_traits::pow(domain.length(), n);
    Sides::new(format!("u = {u}, {curve}")).equal(
        "the explicit sum over [a, b]",
        implementation(curve, u.clone()).coordinates().to_vec(),
        sum.into_iter()
            .map(|x| x / length.clone())
            .collect::<Vec<_>>(),
        Rounding::new(17 * n + 2, magnitude(curve, &u)),
    )
}
