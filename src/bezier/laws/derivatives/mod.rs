//! Laws of derivatives, end curvature, parabolas and integrals.
//!
//! What a derivative is compared with is found by another route than the statements: from the power
//! form of the Bernstein polynomials by Leibniz's rule,
//!
//! ```text
//! dᵖ/dtᵖ tⁱ·sⁿ⁻ⁱ = Σₖ C(p, k)·i⋯(i − k + 1)·tⁱ⁻ᵏ·(−1)ᵖ⁻ᵏ·(n − i)⋯(n − i − p + k + 1)·sⁿ⁻ⁱ⁻ᵖ⁺ᵏ,   s = 1 − t
//! ```
//!
//! # Rounding
//!
//! With C(n, i)·i⋯(i − k + 1)·(n − i)⋯(n − i − p + k + 1) = n⋯(n − p + 1)·C(n − p, i − k) the absolute
//! values of these terms, times C(n, i)·|bᵢ| and summed over i and k, are at most
//! n⋯(n − p + 1)·2ᵖ·(|t| + |s|)ⁿ⁻ᵖ·max|bᵢ|. The same bound holds for the other forms of the derivative.
//! A term passes 2n roundings in the powers, 5 in the product with its whole factors, p in the sum
//! over k, n + 1 in the sum over i, 3p in the division by (b − a)ᵖ: at most 3n + 4p + 6.

mod basis;
mod curvature;
mod curve;
mod integral;
mod quadratic;

pub use basis::*;
pub use curvature::*;
pub use curve::*;
pub use integral::*;
pub use quadratic::*;

use num_traits::Zero;

use super::largest_coordinate;
use crate::affine::{Affine, Interval};
use crate::bezier::{BezierCurve, binomial};
use crate::scalar::Scalar;

/// n(n − 1)⋯(n − k + 1)
fn falling<T: Scalar>(n: usize, k: usize) -> T {
    (0..k).fold(T::one(), |product, j| {
        product * T::from_integer(n as i64 - j as i64)
    })
}

/// The p-th derivative of the Bernstein polynomial over [0, 1], by Leibniz's rule.
fn leibniz<T: Scalar>(n: usize, i: i64, p: usize, t: &T) -> T {
    let Some(i) = usize::try_from(i).ok().filter(|i| *i <= n) else {
        return T::zero();
    };
    let s = T::one() - t.clone();
    let sum = (0..=p)
        .filter(|k| *k <= i && p - k <= n - i)
        .fold(T::zero(), |sum, k| {
            let factor =
                binomial::<T>(p, k as i64) * falling::<T>(i, k) * falling::<T>(n - i, p - k);
            let term = factor
                * num_traits::pow(t.clone(), i - k)
                * num_traits::pow(s.clone(), n - i - (p - k));
            if (p - k).is_multiple_of(2) {
                sum + term
            } else {
                sum - term
            }
        });
    binomial::<T>(n, i as i64) * sum
}

/// The coordinates of the p-th derivative of the curve at u, by Leibniz's rule.
fn derivative_by_leibniz<P: Affine>(
    curve: &BezierCurve<P>,
    p: usize,
    u: &P::Scalar,
) -> Vec<P::Scalar> {
    let n = curve.degree();
    let t = curve.domain().local(u.clone());
    let scale = num_traits::pow(curve.domain().length(), p);
    let mut sum = vec![P::Scalar::zero(); P::DIMENSION];
    for (i, point) in curve.control_points().iter().enumerate() {
        if is_zero(point.coordinates()) {
            continue;
        }
        let weight = leibniz(n, i as i64, p, &t);
        for (total, coordinate) in sum.iter_mut().zip(point.coordinates()) {
            *total += weight.clone() * coordinate.clone();
        }
    }
    sum.into_iter().map(|total| total / scale.clone()).collect()
}

/// n⋯(n − p + 1)·2ᵖ·(|t| + |1 − t|)ⁿ⁻ᵖ/|b − a|ᵖ
fn basis_magnitude<T: Scalar>(domain: &Interval<T>, n: usize, p: usize, u: &T) -> f64 {
    if p > n {
        return 0.0;
    }
    let t = domain.local(u.clone());
    let s = T::one() - t.clone();
    let per_order = 2.0 / domain.length().magnitude();
    let factor: f64 = (0..p).map(|j| (n - j) as f64 * per_order).product();
    factor * (t.magnitude() + s.magnitude()).powi((n - p) as i32)
}

/// The same times the largest coordinate.
fn derivative_magnitude<P: Affine>(curve: &BezierCurve<P>, p: usize, u: &P::Scalar) -> f64 {
    largest_coordinate(curve.control_points())
        * basis_magnitude(curve.domain(), curve.degree(), p, u)
}

/// Whether a term adds nothing; on unit control values that saves almost all work.
fn is_zero<T: Scalar>(coordinates: &[T]) -> bool {
    coordinates.iter().all(Zero::is_zero)
}

/// The coordinates of Σᵢ vᵢ·Bᵢᵐ(t) times a factor, for a list of coordinate lists v₀ … vₘ.
fn bernstein_sum<T: Scalar>(factor: &T, values: &[Vec<T>], t: &T, dimension: usize) -> Vec<T> {
    let mut sum = vec![T::zero(); dimension];
    if let Some(m) = values.len().checked_sub(1) {
        for (i, value) in values.iter().enumerate() {
            if is_zero(value) {
                continue;
            }
            let weight = crate::bezier::bernstein(m, i as i64, t.clone());
            for (total, coordinate) in sum.iter_mut().zip(value) {
                *total += weight.clone() * coordinate.clone();
            }
        }
    }
    sum.into_iter()
        .map(|total| factor.clone() * total)
        .collect()
}

/// Δᵖbᵢ = Σⱼ (−1)ᵖ⁻ʲ·C(p, j)·bᵢ₊ⱼ for all i, in coordinates.
fn binomial_differences<P: Affine>(points: &[P], p: usize) -> Vec<Vec<P::Scalar>> {
    points
        .windows(p + 1)
        .map(|window| {
            let mut sum = vec![P::Scalar::zero(); P::DIMENSION];
            for (j, point) in window.iter().enumerate() {
                if is_zero(point.coordinates()) {
                    continue;
                }
                let weight = binomial::<P::Scalar>(p, j as i64);
                let weight = if (p - j).is_multiple_of(2) {
                    weight
                } else {
                    -weight
                };
                for (total, coordinate) in sum.iter_mut().zip(point.coordinates()) {
                    *total += weight.clone() * coordinate.clone();
                }
            }
            sum
        })
        .collect()
}

/// n(n − 1)⋯(n − p + 1)/(b − a)ᵖ
fn factor<P: Affine>(curve: &BezierCurve<P>, p: usize) -> P::Scalar {
    falling::<P::Scalar>(curve.degree(), p) / num_traits::pow(curve.domain().length(), p)
}
