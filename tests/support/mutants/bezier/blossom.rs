//! Wrong blossoms, and wrong curves over arbitrary intervals.

use cagd::affine::{Affine, Interval, Linear};
use cagd::bezier::{BezierCurve, BlossomTriangle, binomial, elementary_symmetric};
use cagd::scalar::Scalar;
use num_traits::{One, Zero};

/// Evaluates the curve at the first argument.
pub fn first_argument_only<P: Affine>(curve: &BezierCurve<P>, arguments: &[P::Scalar]) -> P {
    let first = arguments.first().cloned();
    curve.at(first.unwrap_or_else(|| curve.domain().start()))
}

/// Evaluates the curve at the mean of the arguments: symmetric, but not affine in each.
pub fn mean_argument<P: Affine>(curve: &BezierCurve<P>, arguments: &[P::Scalar]) -> P {
    let count = P::Scalar::from_integer(arguments.len().max(1) as i64);
    let sum = arguments
        .iter()
        .fold(P::Scalar::zero(), |sum, x| sum + x.clone());
    curve.at(sum / count)
}

/// Takes the mean of the curve points at the arguments: symmetric, but not affine in each.
pub fn mean_of_points<P: Affine>(curve: &BezierCurve<P>, arguments: &[P::Scalar]) -> P {
    let weight = P::Scalar::from_ratio(1, arguments.len().max(1) as i64);
    let points: Vec<P> = arguments.iter().map(|x| curve.at(x.clone())).collect();
    match points.is_empty() {
        true => curve.at(curve.domain().start()),
        false => P::from_fn(|k| {
            points.iter().fold(P::Scalar::zero(), |sum, point| {
                sum + point.coordinates()[k].clone() * weight.clone()
            })
        }),
    }
}

/// Uses the arguments as if the domain were [0, 1].
pub fn domain_forgotten<P: Affine>(curve: &BezierCurve<P>, arguments: &[P::Scalar]) -> P {
    let curve = curve.reparametrised(Interval::unit());
    value(&curve, arguments)
}

/// Swaps t and 1 − t in the last step.
pub fn last_step_reversed<P: Affine>(curve: &BezierCurve<P>, arguments: &[P::Scalar]) -> P {
    let mut arguments = arguments.to_vec();
    if let Some(last) = arguments.last_mut() {
        *last = curve.domain().start() + curve.domain().end() - last.clone();
    }
    value(curve, &arguments)
}

fn value<P: Affine>(curve: &BezierCurve<P>, arguments: &[P::Scalar]) -> P {
    curve.blossom().at(arguments).expect("n finite arguments")
}

/// Does not divide the elementary symmetric polynomial by the number of its terms.
pub fn not_divided<T: Scalar>(power: usize, arguments: &[T]) -> T {
    elementary_symmetric(arguments)[power].clone()
}

/// Multiplies the first k arguments, as if n were k.
pub fn degree_ignored<T: Scalar>(power: usize, arguments: &[T]) -> T {
    arguments[..power]
        .iter()
        .fold(T::one(), |product, x| product * x.clone())
}

/// Takes the k-th power of the mean.
pub fn power_of_mean<T: Scalar>(power: usize, arguments: &[T]) -> T {
    let sum = arguments.iter().fold(T::zero(), |sum, x| sum + x.clone());
    num_traits::pow(sum / binomial::<T>(arguments.len(), 1), power)
}

/// Labels the scheme at the mirrored parameter.
pub fn triangle_reversed<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> BlossomTriangle<P> {
    let mirrored = curve.domain().start() + curve.domain().end() - u;
    curve.blossom().triangle(mirrored)
}

/// Labels the scheme of the reversed polygon.
pub fn polygon_reversed<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> BlossomTriangle<P> {
    let points = curve.control_points().iter().rev().cloned();
    let reversed = BezierCurve::on(curve.domain().clone(), points).expect("finite control points");
    reversed.blossom().triangle(u)
}

/// Labels the scheme of a curve over [0, 1].
pub fn triangle_domain_forgotten<P: Affine>(
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> BlossomTriangle<P> {
    let curve = curve.reparametrised(Interval::unit());
    curve.blossom().triangle(u)
}

/// The point and its derivatives of order 1 to n, with an extra factor for each order p.
fn jet<P: Affine>(
    curve: &BezierCurve<P>,
    u: P::Scalar,
    factor: impl Fn(usize) -> P::Scalar,
) -> (P, Vec<P::Difference>) {
    let (point, derivatives) = crate::support::jets::jet(curve, u);
    let scaled = derivatives
        .iter()
        .zip(1..)
        .map(|(derivative, order)| derivative.scaled(factor(order)));
    (point, scaled.collect())
}

/// Differentiates with respect to t and not to u.
pub fn inner_derivative_forgotten<P: Affine>(
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> (P, Vec<P::Difference>) {
    let length = curve.domain().length();
    jet(curve, u, |order| num_traits::pow(length.clone(), order))
}

/// Has the factor 1/(b − a) once, whatever the order.
pub fn inner_derivative_once<P: Affine>(
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> (P, Vec<P::Difference>) {
    let length = curve.domain().length();
    jet(curve, u, |order| num_traits::pow(length.clone(), order - 1))
}

/// Treats the parameter as one of [0, 1].
pub fn parameter_not_mapped<P: Affine>(
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> (P, Vec<P::Difference>) {
    let start = curve.domain().start();
    jet(curve, u - start, |_| P::Scalar::one())
}

/// Σ bᵢ·C(n, i)·weight(i), for segments.
fn segment_with<P: Affine>(
    curve: &BezierCurve<P>,
    weight: impl Fn(usize, usize) -> P::Scalar,
) -> P {
    let n = curve.degree();
    P::from_fn(|k| {
        let points = curve.control_points().iter().enumerate();
        points.fold(P::Scalar::zero(), |sum, (i, point)| {
            let factor = binomial::<P::Scalar>(n, i as i64) * weight(n, i);
            sum + factor * point.coordinates()[k].clone()
        })
    })
}

/// The sum as the slides print it, with (b − a)ᵐ⁻ⁱ where (b − u)ᵐ⁻ⁱ belongs.
pub fn segment_as_printed<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let domain = curve.domain();
    let after = u - domain.start();
    segment_with(curve, |m, i| {
        num_traits::pow(after.clone(), i) * num_traits::pow(domain.length(), m - i)
            / num_traits::pow(domain.length(), m)
    })
}

/// Forgets the factor (b − a)⁻ⁿ.
pub fn segment_not_divided<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    let domain = curve.domain();
    let (after, before) = (u.clone() - domain.start(), domain.end() - u);
    segment_with(curve, |n, i| {
        num_traits::pow(after.clone(), i) * num_traits::pow(before.clone(), n - i)
    })
}

/// Swaps u − a and b − u.
pub fn segment_reversed<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P {
    curve.at(curve.domain().start() + curve.domain().end() - u)
}
