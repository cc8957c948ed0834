//! Wrong derivatives, curvatures, parabolas and integrals.

use std::num::NonZeroUsize;

use cagd::affine::{Affine, Interval, Linear, Point};
use cagd::bezier::{
    BezierCurve, CasteljauTriangle, bernstein, bernstein_higher_derivative, binomial,
    forward_differences,
};
use cagd::scalar::{OrderedScalar, Scalar};
use num_traits::{One, Zero};

/// Differentiates Bᵢⁿ with the two neighbours exchanged: the sign is wrong.
pub fn neighbours_exchanged<T: Scalar>(n: usize, i: i64, t: T) -> T {
    let m = n.saturating_sub(1);
    T::from_integer(n as i64) * (bernstein(m, i, t.clone()) - bernstein(m, i - 1, t))
}

/// Keeps the degree n in the derivative of Bᵢⁿ.
pub fn degree_kept<T: Scalar>(n: usize, i: i64, t: T) -> T {
    T::from_integer(n as i64) * (bernstein(n, i - 1, t.clone()) - bernstein(n, i, t))
}

/// Forgets that a polynomial beyond the ends is 0: leaves out the left neighbour.
pub fn one_neighbour<T: Scalar>(n: usize, i: i64, t: T) -> T {
    -T::from_integer(n as i64) * bernstein(n.saturating_sub(1), i, t)
}

/// The formula as printed on the slide: the degree m − j instead of m − p.
pub fn printed_degree<T: Scalar>(domain: &Interval<T>, m: usize, i: i64, p: usize, u: T) -> T {
    let t = domain.local(u);
    let factor = (0..p).fold(T::one(), |product, k| {
        product * (T::from_integer(m as i64 - k as i64) / domain.length())
    });
    let sum = (0..=p).fold(T::zero(), |sum, j| {
        let term = match m.checked_sub(j) {
            Some(degree) => binomial::<T>(p, j as i64) * bernstein(degree, i - j as i64, t.clone()),
            None => T::zero(),
        };
        if (p - j).is_multiple_of(2) {
            sum + term
        } else {
            sum - term
        }
    });
    factor * sum
}

/// Forgets the chain rule for the interval.
pub fn basis_chain_rule_forgotten<T: Scalar>(
    domain: &Interval<T>,
    m: usize,
    i: i64,
    p: usize,
    u: T,
) -> T {
    bernstein_higher_derivative(&Interval::unit(), m, i, p, domain.local(u))
}

/// All signs of the alternating sum positive.
pub fn signs_forgotten<T: Scalar>(domain: &Interval<T>, m: usize, i: i64, p: usize, u: T) -> T {
    let Some(lower) = m.checked_sub(p) else {
        return T::zero();
    };
    let t = domain.local(u);
    let factor = (0..p).fold(T::one(), |product, k| {
        product * (T::from_integer(m as i64 - k as i64) / domain.length())
    });
    (0..=p).fold(T::zero(), |sum, j| {
        sum + factor.clone()
            * binomial::<T>(p, j as i64)
            * bernstein(lower, i - j as i64, t.clone())
    })
}

/// A hodograph whose control vectors are those of the right one times a number.
fn rescaled<P: Affine>(
    curve: &BezierCurve<P>,
    order: NonZeroUsize,
    factor: P::Scalar,
) -> BezierCurve<P::Difference> {
    let right = curve.higher_derivative(order);
    let vectors = right.control_points().iter();
    let vectors: Vec<P::Difference> = vectors.map(|v| v.scaled(factor.clone())).collect();
    BezierCurve::on(curve.domain().clone(), vectors).expect("finite vectors")
}

/// The control vectors of the hodograph without the factor n, as in the garbled corollary.
pub fn factor_forgotten<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P::Difference> {
    let degree = curve.degree().max(1) as i64;
    rescaled(curve, NonZeroUsize::MIN, P::Scalar::from_ratio(1, degree))
}

/// Forgets the chain rule: the factor 1/(b − a) is missing.
pub fn chain_rule_forgotten<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P::Difference> {
    rescaled(curve, NonZeroUsize::MIN, curve.domain().length())
}

/// Differences the wrong way round.
pub fn reversed_legs<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P::Difference> {
    rescaled(curve, NonZeroUsize::MIN, -P::Scalar::one())
}

/// The factor n² instead of n(n − 1) in the second derivative.
pub fn square_of_the_degree<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P::Difference {
    let n = curve.degree() as i64;
    let right = curve.second_derivative().at(u);
    right.scaled(P::Scalar::from_ratio(n, (n - 1).max(1)))
}

/// The second difference with the factor 1 instead of 2 in the middle: not a difference at all.
pub fn middle_counted_once<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> P::Difference {
    let legs = forward_differences(curve.control_points(), NonZeroUsize::MIN);
    let n = P::Scalar::from_integer(curve.degree() as i64);
    let length = curve.domain().length();
    let extra = legs[0].scaled(n / (length.clone() * length));
    let right = curve.second_derivative().at(u);
    P::Difference::from_fn(|k| right.coordinates()[k].clone() + extra.coordinates()[k].clone())
}

/// The factor of the class notes, n⋯(n − p): one factor too many.
pub fn one_factor_too_many<P: Affine>(
    curve: &BezierCurve<P>,
    order: NonZeroUsize,
) -> BezierCurve<P::Difference> {
    let last = curve.degree() as i64 - order.get() as i64;
    rescaled(curve, order, P::Scalar::from_integer(last))
}

/// The factor nᵖ instead of n(n − 1)⋯(n − p + 1).
pub fn power_of_the_degree<P: Affine>(
    curve: &BezierCurve<P>,
    order: NonZeroUsize,
) -> BezierCurve<P::Difference> {
    let n = curve.degree() as i64;
    let factor = (0..order.get().min(curve.degree())).fold(P::Scalar::one(), |product, k| {
        product * P::Scalar::from_ratio(n, n - k as i64)
    });
    rescaled(curve, order, factor)
}

/// The interval is used once and not p times.
pub fn one_interval_length<P: Affine>(
    curve: &BezierCurve<P>,
    order: NonZeroUsize,
) -> BezierCurve<P::Difference> {
    let length = curve.domain().length();
    rescaled(curve, order, num_traits::pow(length, order.get() - 1))
}

/// Takes the difference of column p instead of column n − p.
pub fn wrong_column<P: Affine>(
    curve: &BezierCurve<P>,
    u: P::Scalar,
    order: NonZeroUsize,
) -> P::Difference {
    let triangle = curve.triangle(u);
    let p = order.get();
    let column = triangle.column(p.min(curve.degree()));
    let zero = P::Difference::from_fn(|_| P::Scalar::zero());
    let difference = forward_differences(column, order).into_iter().next();
    let factor = (0..p).fold(P::Scalar::one(), |product, k| {
        product * P::Scalar::from_integer(curve.degree() as i64 - k as i64)
            / curve.domain().length()
    });
    difference.unwrap_or(zero).scaled(factor)
}

/// Takes the derivative at t for that at 1 − t.
pub fn triangle_from_the_other_end<P: Affine>(
    curve: &BezierCurve<P>,
    u: P::Scalar,
    order: NonZeroUsize,
) -> P::Difference {
    let t = curve.domain().local(u);
    curve
        .higher_derivative(order)
        .at(curve.domain().global(P::Scalar::one() - t))
}

/// A triangle with the control points in reverse order.
pub fn reversed_triangle<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> CasteljauTriangle<P> {
    let points = curve.control_points().iter().rev().cloned();
    BezierCurve::on(curve.domain().clone(), points)
        .expect("finite points")
        .triangle(u)
}

/// The signed square of the curvature without the factor (n − 1)/n.
pub fn curvature_factor_forgotten<T: OrderedScalar>(
    curve: &BezierCurve<Point<T, 2>>,
    u: T,
) -> Option<T> {
    let n = curve.degree() as i64;
    let factor = T::from_ratio(n, (n - 1).max(1));
    right_curvature(curve, u).map(|k| k * factor.clone() * factor)
}

/// The curvature of the reversed curve: the formula of the start used at the end too.
pub fn curvature_of_the_reversed_curve<T: OrderedScalar>(
    curve: &BezierCurve<Point<T, 2>>,
    u: T,
) -> Option<T> {
    let at_end = u == curve.domain().end();
    right_curvature(curve, u).map(|k| if at_end { -k } else { k })
}

/// Says 0 at a singular point instead of nothing.
pub fn singular_taken_for_straight<T: OrderedScalar>(
    curve: &BezierCurve<Point<T, 2>>,
    u: T,
) -> Option<T> {
    Some(right_curvature(curve, u).unwrap_or(T::zero()))
}

/// The right value, to be spoilt.
fn right_curvature<T: OrderedScalar>(curve: &BezierCurve<Point<T, 2>>, u: T) -> Option<T> {
    let [first, second] = curve.derivatives(u);
    cagd::curves::curvature::plane_curvature_squared(&first, &second)
}

/// The tangent b₁ − b₀ instead of 2(b₁ − b₀).
pub fn tangent_not_doubled<P: Affine>(curve: &BezierCurve<P>, x: P::Scalar, y: P::Scalar) -> P {
    let map = cagd::bezier::ParabolaMap::of(curve).expect("a quadratic curve");
    map.apply(x * P::Scalar::from_ratio(1, 2), y)
}

/// The axis direction b₂ − b₀ instead of b₂ − 2b₁ + b₀.
pub fn chord_for_axis<P: Affine>(curve: &BezierCurve<P>, x: P::Scalar, y: P::Scalar) -> P {
    let map = cagd::bezier::ParabolaMap::of(curve).expect("a quadratic curve");
    map.apply(x + y.clone(), y)
}

/// The mean with the weight 1/m instead of 1/(m + 1).
pub fn divided_by_the_degree<V: Linear>(curve: &BezierCurve<V>) -> V {
    let m = curve.degree().max(1) as i64;
    curve.integral().scaled(V::Scalar::from_ratio(m + 1, m))
}

/// Forgets the length of the interval.
pub fn interval_length_forgotten<V: Linear>(curve: &BezierCurve<V>) -> V {
    let length = curve.domain().length();
    curve.integral().scaled(V::Scalar::one() / length)
}

/// The trapezoidal rule over the control polygon: half weight for the ends.
pub fn ends_count_half<V: Linear>(curve: &BezierCurve<V>) -> V {
    let points = curve.control_points();
    let (first, last) = (points[0].clone(), points[points.len() - 1].clone());
    let half = curve.domain().length() / V::Scalar::from_integer(2 * points.len() as i64);
    let right = curve.integral();
    V::from_fn(|k| {
        right.coordinates()[k].clone()
            - (first.coordinates()[k].clone() + last.coordinates()[k].clone()) * half.clone()
    })
}

/// Adds the control vectors without their share of the interval.
pub fn antiderivative_without_share<P: Affine>(
    hodograph: &BezierCurve<P::Difference>,
    start: P,
) -> BezierCurve<P> {
    let mut points = vec![start];
    for (i, vector) in hodograph.control_points().iter().enumerate() {
        points.push(points[i].translated(vector));
    }
    BezierCurve::on(hodograph.domain().clone(), points).expect("finite points")
}
