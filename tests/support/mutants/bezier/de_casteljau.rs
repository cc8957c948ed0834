//! Wrong schemes of de Casteljau.

use cagd::affine::Affine;
use cagd::bezier::{BezierCurve, CasteljauTriangle};
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
