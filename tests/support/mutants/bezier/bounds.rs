//! Wrong bounds.

use cagd::affine::Affine;
use cagd::bezier::BezierCurve;
use cagd::bezier::bounds::{maximum_norm, segment_distance_squared};
use cagd::scalar::{OrderedScalar, Scalar};
use num_traits::Zero;

fn largest<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    curve.largest_second_difference(maximum_norm)
}

fn ratio<P: Affine>(numerator: usize, denominator: usize) -> P::Scalar {
    P::Scalar::from_ratio(numerator as i64, denominator as i64)
}

/// n²/8 for n(n − 1)/8: safe, but not the bound.
pub fn degree_squared<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    ratio::<P>(curve.degree().pow(2), 8) * largest(curve)
}

/// Takes Δ²bₖ for the control vectors of b″, without the factor n(n − 1).
pub fn factor_forgotten<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    ratio::<P>(1, 8) * largest(curve)
}

/// The distance of the control points from the chord as a set, as the class notes have it: in each coordinate.
pub fn distance_to_the_set<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let points = curve.control_points();
    let ends = [&points[0], &points[points.len() - 1]];
    let coordinate = |point: &P, k: usize| point.coordinates()[k].clone();
    points
        .iter()
        .flat_map(|point| (0..P::DIMENSION).map(move |k| (point, k)))
        .map(|(point, k)| {
            let [a, b] = ends.map(|end| coordinate(end, k));
            let x = coordinate(point, k);
            let below = a.clone().min(b.clone()) - x.clone();
            let above = x - a.max(b);
            below.max(above).max(P::Scalar::zero())
        })
        .fold(P::Scalar::zero(), OrderedScalar::max)
}

/// First differences for second differences.
pub fn first_differences<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    let longest = curve
        .control_points()
        .windows(2)
        .map(|leg| maximum_norm(&leg[1].difference(&leg[0])))
        .fold(P::Scalar::zero(), OrderedScalar::max);
    ratio::<P>(n * n.saturating_sub(1), 8) * longest
}

/// n/8 for odd degrees too.
pub fn parity_forgotten<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    ratio::<P>(curve.degree(), 8) * largest(curve)
}

/// ⌊n/2⌋² for ⌊n/2⌋·⌈n/2⌉.
pub fn rounded_down_twice<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let n = curve.degree();
    ratio::<P>((n / 2).pow(2), 2 * n.max(1)) * largest(curve)
}

/// The library's bound for the distance from the segment.
pub fn worst_control_point<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let points = curve.control_points();
    distances(curve, points)
}

/// Looks at the control points in the middle only.
pub fn middle_control_point<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let middle = curve.degree() / 2;
    distances(curve, &curve.control_points()[middle..=middle])
}

/// Measures from the first control point instead of the segment.
pub fn from_the_start<P: Affine>(curve: &BezierCurve<P>) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let points = curve.control_points();
    points
        .iter()
        .map(|point| segment_distance_squared(point, &points[0], &points[0]))
        .fold(P::Scalar::zero(), OrderedScalar::max)
}

fn distances<P: Affine>(curve: &BezierCurve<P>, points: &[P]) -> P::Scalar
where
    P::Scalar: OrderedScalar,
{
    let ends = curve.control_points();
    points
        .iter()
        .map(|point| segment_distance_squared(point, &ends[0], &ends[curve.degree()]))
        .fold(P::Scalar::zero(), OrderedScalar::max)
}

/// Divides the bound by 2 a step instead of 4.
pub fn error_halved_a_step<P: Affine>(curve: &BezierCurve<P>, tolerance: &P::Scalar) -> usize
where
    P::Scalar: OrderedScalar,
{
    2 * depth(curve, tolerance)
}

/// Rounds the logarithm down.
pub fn rounded_down<P: Affine>(curve: &BezierCurve<P>, tolerance: &P::Scalar) -> usize
where
    P::Scalar: OrderedScalar,
{
    depth(curve, tolerance).saturating_sub(1)
}

/// One halving more to be on the safe side.
pub fn one_more<P: Affine>(curve: &BezierCurve<P>, tolerance: &P::Scalar) -> usize
where
    P::Scalar: OrderedScalar,
{
    depth(curve, tolerance) + 1
}

/// The library's number of halvings.
pub fn depth<P: Affine>(curve: &BezierCurve<P>, tolerance: &P::Scalar) -> usize
where
    P::Scalar: OrderedScalar,
{
    curve
        .subdivision_depth(tolerance, maximum_norm)
        .expect("a positive tolerance")
}
