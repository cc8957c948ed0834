//! Wrong ways to a curve point.

use cagd::affine::Affine;
use cagd::bezier::{BezierCurve, bernstein};
use num_traits::{One, pow};

/// Mixes up t and 1 − t.
pub fn parameter_reversed<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    curve.at(curve.domain().global(P::Scalar::one() - t))
}

/// Forgets the map to the unit interval.
pub fn domain_forgotten<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    weighted(curve, |i| bernstein(curve.degree(), i as i64, u.clone()))
}

/// Sums tⁱ(1 − t)ⁿ⁻ⁱ·bᵢ without the binomial coefficients.
pub fn no_binomials<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    let s = P::Scalar::one() - t.clone();
    weighted(curve, |i| {
        pow(t.clone(), i) * pow(s.clone(), curve.degree() - i)
    })
}

/// Reads bᵢ₊₁ for bᵢ, as the sum of the notes does for i = 1, and repeats the last point.
pub fn index_off_by_one<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let points = curve.control_points();
    let shifted = points.iter().skip(1).chain(points.last()).cloned();
    let shifted = BezierCurve::on(curve.domain().clone(), shifted).expect("finite control points");
    shifted.at(u)
}

/// Takes (1 − t)ⁿ out of the sum for every t, so that t/(1 − t) grows without bound.
pub fn powers_of_the_quotient<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let t = curve.domain().local(u);
    let s = P::Scalar::one() - t.clone();
    let n = curve.degree();
    let factor = pow(s.clone(), n);
    weighted(curve, |i| {
        factor.clone() * cagd::bezier::binomial(n, i as i64) * pow(t.clone() / s.clone(), i)
    })
}

/// The sum of the control points with any weights.
fn weighted<P: Affine>(curve: &BezierCurve<P>, weight: impl Fn(usize) -> P::Scalar) -> P {
    let weights: Vec<P::Scalar> = (0..=curve.degree()).map(weight).collect();
    P::from_fn(|k| {
        std::iter::zip(&weights, curve.control_points())
            .map(|(weight, point)| weight.clone() * point.coordinates()[k].clone())
            .reduce(|sum, term| sum + term)
            .expect("a curve has control points")
    })
}
