//! Laws of end points, affine images and reversal.

use super::super::{largest_coordinate, magnitude};
use crate::affine::{Affine, AffineMap, Interval, Point};
use crate::bezier::BezierCurve;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `bezier-end-values`: b(a) = b₀ and b(b) = bₙ on [a, b].
///
/// `implementation(curve, u)` must give the point at the parameter u.
///
/// # Rounding
///
/// None: the local parameters are exactly 0 and 1, and then every step of de Casteljau takes one of its two points.
pub fn end_values<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> P,
    curve: &BezierCurve<P>,
) -> Sides<P::Scalar> {
    let points = curve.control_points();
    let start = implementation(curve, curve.domain().start());
    let end = implementation(curve, curve.domain().end());
    Sides::new(curve)
        .equal(
            "at the start the curve is at the first control point",
            start.coordinates().to_vec(),
            points[0].coordinates().to_vec(),
            Rounding::none(),
        )
        .equal(
            "at the end the curve is at the last control point",
            end.coordinates().to_vec(),
            points[curve.degree()].coordinates().to_vec(),
            Rounding::none(),
        )
}

/// `bezier-endpoint-interpolating`: a curve scheme passes through the first and the last control
/// point, at the start and the end of its parameter interval.
///
/// `scheme(control_points, domain, u)` must give the point at u of the curve with these control points.
/// Any scheme may be judged, not only Bézier's.
///
/// # Rounding
///
/// The weights of a scheme sum to 1 and are 0 but for one at the ends. They may have passed some
/// roundings: 3 for each of n steps, like those of de Casteljau.
pub fn endpoint_interpolating<P: Affine>(
    scheme: impl Fn(&[P], &Interval<P::Scalar>, P::Scalar) -> P,
    control_points: &[P],
    domain: &Interval<P::Scalar>,
) -> Sides<P::Scalar> {
    let rounding = Rounding::new(3 * control_points.len(), largest_coordinate(control_points));
    let ends = [
        (domain.start(), control_points.first()),
        (domain.end(), control_points.last()),
    ];
    let sides = Sides::new(format!(
        "control points {control_points:?} on [{}, {}]",
        domain.start(),
        domain.end()
    ));
    ends.into_iter().fold(sides, |sides, (u, expected)| {
        let expected = expected.map_or(vec![], |point| point.coordinates().to_vec());
        let found = scheme(control_points, domain, u.clone());
        sides.equal(
            format!("at {u} the curve is at the end of its polygon"),
            found.coordinates().to_vec(),
            expected,
            rounding,
        )
    })
}

/// `bezier-affine-invariance`: α(b(u)) = Σ α(bᵢ)·Bᵢⁿ(t) for an affine map α.
///
/// `implementation(curve, α)` must give the image of the curve, by its control points.
///
/// # Rounding
///
/// A term of the left side passes 3n roundings for the point and D + 1 for the map; on the right side
/// the map comes first. With |A| the largest sum of a row, Σ|terms| is at most
/// |A|·max|bᵢ|·(|t| + |1 − t|)ⁿ for the linear part and |a|·(|t| + |1 − t|)ⁿ for the translation.
pub fn affine_invariance<T: Scalar, const D: usize, const E: usize>(
    implementation: impl Fn(&BezierCurve<Point<T, D>>, &AffineMap<T, D, E>) -> BezierCurve<Point<T, E>>,
    curve: &BezierCurve<Point<T, D>>,
    map: &AffineMap<T, D, E>,
    u: T,
) -> Sides<T> {
    let image = implementation(curve, map);
    let row_sum = |row: usize| -> f64 { (0..D).map(|k| map.linear()[(row, k)].magnitude()).sum() };
    let largest_row = (0..E).map(row_sum).fold(0.0, f64::max);
    let translation = map.translation().iter().map(Scalar::magnitude);
    let t = curve.domain().local(u.clone());
    let spread = (t.magnitude() + (T::one() - t).magnitude()).powi(curve.degree() as i32);
    let bound = largest_row * magnitude(curve, &u) + translation.fold(0.0, f64::max) * spread;
    let n = curve.degree();
    Sides::new(format!("u = {u}, {map:?}, {curve}")).equal(
        "the image of the point is the point of the image",
        map.point(&curve.at(u.clone())).coordinates().to_vec(),
        image.at(u).coordinates().to_vec(),
        Rounding::new(6 * n + 2 * (D + 1), bound),
    )
}

/// `bezier-symmetry`: the curve of bₙ … b₀ is b̃(t) = b(1 − t).
///
/// `implementation(curve)` must give the reversed curve, over the same domain.
///
/// # Rounding
///
/// Both sides are values of de Casteljau, 3n roundings a term each.
/// Their local parameters differ by rounding too. Let s be the largest of |a|, |b|, |u| and the
/// mirrored |v|, divided by |b − a|. Then v = a + b − u is off by 3·s·|b − a| units of 2⁻⁵³, and a local
/// parameter, at most 2s in size, by three units of its own size: 3s + 6s + 6s = 15s in all.
/// As |b′| is at most 2n·max|bᵢ|·(|t| + |1 − t|)ⁿ⁻¹, the values differ by 30·n·s units of the magnitude.
pub fn symmetry<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> BezierCurve<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let reversed = implementation(curve);
    let domain = curve.domain();
    let mirrored = domain.start() + domain.end() - u.clone();
    let n = curve.degree();
    let size = [domain.start(), domain.end(), u.clone(), mirrored.clone()]
        .iter()
        .map(Scalar::magnitude)
        .fold(0.0, f64::max);
    let stretch = (size / domain.length().magnitude()).max(1.0);
    let bound = magnitude(curve, &u).max(magnitude(curve, &mirrored));
    Sides::new(format!("u = {u}, {curve}"))
        .equal(
            "the reversed curve at u is the curve at the mirrored parameter",
            reversed.at(u).coordinates().to_vec(),
            curve.at(mirrored).coordinates().to_vec(),
            Rounding::new(6 * n + 30 * n * stretch.ceil() as usize, bound),
        )
        .equal(
            "it starts where the curve ends",
            reversed.at(domain.start()).coordinates().to_vec(),
            curve.at(domain.end()).coordinates().to_vec(),
            Rounding::none(),
        )
}
