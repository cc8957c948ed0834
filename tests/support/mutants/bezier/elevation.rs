//! Wrong degree elevations and Bernstein approximations.

use cagd::affine::Affine;
use cagd::bezier::BezierCurve;
use cagd::scalar::Scalar;

fn elevated_with<P: Affine>(
    curve: &BezierCurve<P>,
    weight: impl Fn(i64, i64) -> P::Scalar,
) -> BezierCurve<P> {
    let points = curve.control_points();
    let n = curve.degree();
    let inner = (1..=n).map(|i| points[i].lerp(&points[i - 1], weight(i as i64, n as i64)));
    let all = std::iter::once(points[0].clone())
        .chain(inner)
        .chain(points.last().cloned());
    BezierCurve::on(curve.domain().clone(), all).expect("finite control points")
}

/// Divides by n where it must be n + 1.
pub fn degree_for_degree_plus_one<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P> {
    elevated_with(curve, P::Scalar::from_ratio)
}

/// Gives the weight of the left neighbour to the right one.
pub fn weights_swapped<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P> {
    elevated_with(curve, |i, n| P::Scalar::from_ratio(n + 1 - i, n + 1))
}

/// Takes the middle of every leg.
pub fn midpoints<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P> {
    elevated_with(curve, |_, _| P::Scalar::from_ratio(1, 2))
}

/// Repeats the last control point.
pub fn last_point_repeated<P: Affine>(curve: &BezierCurve<P>) -> BezierCurve<P> {
    let points = curve.control_points();
    let all = points.iter().chain(points.last()).cloned();
    BezierCurve::on(curve.domain().clone(), all).expect("finite control points")
}

/// Takes the values at (i + 1/2)/(m + 1), the middles of m + 1 equal parts.
pub fn sampled_in_the_middle<P: Affine>(
    function: &dyn Fn(P::Scalar) -> P,
    degree: usize,
) -> BezierCurve<P> {
    let m = degree as i64;
    let values = (0..=m).map(|i| function(P::Scalar::from_ratio(2 * i + 1, 2 * m + 2)));
    BezierCurve::new(values).expect("finite values")
}

/// Takes the values from 1 down to 0.
pub fn sampled_backwards<P: Affine>(
    function: &dyn Fn(P::Scalar) -> P,
    degree: usize,
) -> BezierCurve<P> {
    let m = degree as i64;
    let values = (0..=m).map(|i| function(P::Scalar::from_ratio(m - i, m)));
    BezierCurve::new(values).expect("finite values")
}
