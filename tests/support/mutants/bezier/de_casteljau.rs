//! Wrong schemes of de Casteljau.

use cagd::affine::Affine;
use cagd::bezier::{BezierCurve, CasteljauTriangle, Counted, recursive_at};
use cagd::scalar::Scalar;
use num_traits::One;

/// Mixes up t and 1 − t.
pub fn parameter_reversed<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> CasteljauTriangle<P> {
    let t = curve.domain().local(u);
    curve.triangle(curve.domain().global(P::Scalar::one() - t))
}

/// Forgets the map to the unit interval.
pub fn domain_forgotten<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> CasteljauTriangle<P> {
    let on_unit_interval =
        BezierCurve::new(curve.control_points().to_vec()).expect("finite control points");
    on_unit_interval.triangle(u)
}

/// Leaves out the first control point and repeats the last.
pub fn index_off_by_one<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> CasteljauTriangle<P> {
    let points = curve.control_points();
    let shifted = points.iter().skip(1).chain(points.last()).cloned();
    let shifted = BezierCurve::on(curve.domain().clone(), shifted).expect("finite control points");
    shifted.triangle(u)
}

/// Takes the middle of every leg, whatever the parameter.
pub fn always_midpoints<P: Affine>(curve: &BezierCurve<P>, _: P::Scalar) -> CasteljauTriangle<P> {
    curve.triangle(curve.domain().global(P::Scalar::from_ratio(1, 2)))
}

/// Programs the recursion as it is written.
pub fn recursion_as_written<P: Affine>(
    curve: &BezierCurve<Counted<P>>,
    u: P::Scalar,
) -> Counted<P> {
    recursive_at(curve, u).0
}

/// Keeps all columns though the last is enough.
pub fn all_columns_kept<P: Affine>(curve: &BezierCurve<Counted<P>>, u: P::Scalar) -> Counted<P> {
    curve.triangle(u).tip().clone()
}

/// Believes that recursion computes every point of the scheme once.
pub fn every_point_once<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> (P, u64) {
    let n = curve.degree() as u64;
    (curve.at(u), (n + 1) * (n + 2) / 2)
}

/// Forgets to count the first call.
pub fn first_call_forgotten<P: Affine>(curve: &BezierCurve<P>, u: P::Scalar) -> (P, u64) {
    let (point, calls) = recursive_at(curve, u);
    (point, calls - 1)
}
