//! Evaluation in linear time, for curves of high degree.
//!
//! The algorithm of de Casteljau takes n(n + 1)/2 affine combinations. Both schemes of this file take
//! a constant number of operations for each control point, and both are as stable:
//!
//! - Horner's scheme in the quotient t/(1 − t) or (1 − t)/t, whichever is at most 1
//!   (`schumaker-volk1986`): fastest, and it runs over any field;
//! - the geometric scheme (`wozny-chudy2020`): every intermediate point lies in the convex hull of the
//!   control points, so that nothing overflows at any degree.

use num_traits::{One, pow};

use super::curve::BezierCurve;
use crate::affine::Affine;
use crate::scalar::{Scalar, UNIT_ROUNDOFF};

/// The highest degree for which Horner's scheme runs over rounded numbers.
///
/// Its intermediate sums exceed the control points by a factor of at most 2ⁿ, and its last factor is
/// at least 2⁻ⁿ. With n ≤ 500 and coordinates from 1e-150 to 1e150, all of them stay between
/// 1e-301 and 1e301.
const HORNER_DEGREE: usize = 500;

impl<P: Affine> BezierCurve<P> {
    /// The point b(u), in linear time.
    ///
    /// ```text
    /// b(u) = (1 − t)ⁿ·Σᵢ C(n, i)·xⁱ·bᵢ,     x = t/(1 − t),   if |t| ≤ |1 − t|
    /// b(u) = tⁿ      ·Σᵢ C(n, i)·xⁿ⁻ⁱ·bᵢ,   x = (1 − t)/t,   otherwise
    /// ```
    ///
    /// The sums are Horner's scheme in x. As |x| ≤ 1, no power of x grows.
    ///
    /// For rounded numbers and a degree above 500, where C(n, i) leaves the range of `f64`, another
    /// scheme takes over on [0, 1]: b(u) = Qₙ with
    ///
    /// ```text
    /// h₀ = 1,   hₖ = A/(A + k·(1 − t)),   A = hₖ₋₁·t·(n − k + 1)
    /// Q₀ = b₀,  Qₖ = (1 − hₖ)·Qₖ₋₁ + hₖ·bₖ
    /// ```
    ///
    /// `u` is any number. Where neither scheme can serve (a degree above 500 and t outside [0, 1], or
    /// an intermediate number beyond the range of the number type), the result is that of
    /// [`at`](Self::at); so it is finite wherever that of `at` is.
    ///
    /// # Rounding
    ///
    /// The error of a coordinate is at most γₖ·Σ|Bᵢⁿ(t)|·|bᵢ| (plus k underflows) with k = 5n + 1 up to
    /// degree 500 and k = 20n above, where γₖ = k·u/(1 − k·u), u = 2⁻⁵³; the bound of `at` has k = 3n.
    /// On [0, 1] the sum is at most max|bᵢ|.
    ///
    /// At the ends of the domain the result is exactly the first or the last control point.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::bezier::BezierCurve;
    ///
    /// let curve = BezierCurve::new([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(Point::new))?;
    /// assert_eq!(curve.at_linear(0.5), Point::new([2.0, 3.0]));
    ///
    /// // A straight line, written with degree 4000, where C(4000, 2000) is far beyond the range of f64.
    /// let n = 4000;
    /// let line = BezierCurve::new((0..=n).map(|i| f64::from(i) / f64::from(n)))?;
    /// assert!((line.at_linear(0.3) - 0.3).abs() <= cagd::law::gamma(20 * line.degree()));
    /// # Ok::<(), cagd::bezier::BezierError>(())
    /// ```
    ///
    /// Source: `schumaker-volk1986`; `wozny-chudy2020`, §2.
    #[must_use]
    pub fn at_linear(&self, u: P::Scalar) -> P {
        let t = self.domain().local(u.clone());
        let s = P::Scalar::one() - t.clone();
        let (t_size, s_size) = (t.magnitude(), s.magnitude());
        let point = if P::Scalar::EXACT || self.degree() <= HORNER_DEGREE {
            if t_size <= s_size {
                horner(self.control_points().iter().rev(), t / s.clone(), s)
            } else {
                horner(self.control_points().iter(), s / t.clone(), t)
            }
        } else if t_size + s_size <= 1.0 + 4.0 * UNIT_ROUNDOFF {
            // t is in [0, 1] if |t| + |1 − t| = 1; the sum of the rounded numbers misses it by 2u at most.
            geometric(self.control_points(), t, s)
        } else {
            return self.at(u);
        };
        if point.coordinates().iter().all(Scalar::is_finite) {
            point
        } else {
            self.at(u)
        }
    }
}

/// The sum `baseⁿ·Σⱼ C(n, j)·ratioⁿ⁻ʲ·pointⱼ` over the n + 1 points in the given order.
fn horner<'a, P: Affine>(
    points: impl ExactSizeIterator<Item = &'a P>,
    ratio: P::Scalar,
    base: P::Scalar,
) -> P {
    let degree = points.len() - 1;
    let mut binomial = P::Scalar::one();
    let mut sum = P::from_fn(|_| P::Scalar::from_integer(0));
    for (j, point) in points.enumerate() {
        if j > 0 {
            binomial *= P::Scalar::from_integer((degree - j + 1) as i64);
            binomial /= P::Scalar::from_integer(j as i64);
        }
        sum = P::from_fn(|k| {
            sum.coordinates()[k].clone() * ratio.clone()
                + point.coordinates()[k].clone() * binomial.clone()
        });
    }
    let power = pow(base, degree);
    P::from_fn(|k| sum.coordinates()[k].clone() * power.clone())
}

/// The last point of the geometric scheme; `t` in [0, 1] and `s` = 1 − t.
fn geometric<P: Affine>(points: &[P], t: P::Scalar, s: P::Scalar) -> P {
    let degree = points.len() - 1;
    let mut point = points[0].clone();
    let mut weight = P::Scalar::one();
    for (k, control_point) in points.iter().enumerate().skip(1) {
        let gained = weight * (t.clone() * P::Scalar::from_integer((degree - k + 1) as i64));
        let kept = s.clone() * P::Scalar::from_integer(k as i64);
        // The two weights are quotients, and not 1 − hₖ, so that both have a small relative error.
        let total = gained.clone() + kept.clone();
        weight = gained / total.clone();
        let rest = kept / total;
        point = P::from_fn(|k| {
            point.coordinates()[k].clone() * rest.clone()
                + control_point.coordinates()[k].clone() * weight.clone()
        });
    }
    point
}
