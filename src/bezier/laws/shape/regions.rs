//! Laws of the regions that contain a curve.

use num_traits::Zero;

use super::super::{largest_coordinate, magnitude};
use crate::affine::{Affine, BoundingBox, ConvexHull, Orient, Point};
use crate::bezier::BezierCurve;
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// `bezier-convex-hull`: b(u) ∈ conv{b₀, …, bₙ} for u in the domain.
///
/// A point is in the convex hull exactly if it is in every half-space that contains the control points,
///
/// ```text
/// ⟨d, b(u)⟩ ≤ maxᵢ ⟨d, bᵢ⟩   for every direction d.
/// ```
///
/// `implementation(curve, u)` must give the point at u; the inequality is checked for the given directions.
///
/// # Rounding
///
/// Rounding is monotone, so the rounded t stays in [0, 1], and the point at the rounded t is in the hull too.
/// The point passes 3n roundings a term, the scalar products D on each side. Σ|terms| ≤ |d|₁·max|bᵢ|.
pub fn convex_hull<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar) -> P,
    curve: &BezierCurve<P>,
    u: P::Scalar,
    directions: &[P::Difference],
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let product = |direction: &P::Difference, point: &P| {
        std::iter::zip(direction.coordinates(), point.coordinates())
            .fold(P::Scalar::zero(), |sum, (d, x)| sum + d.clone() * x.clone())
    };
    let point = implementation(curve, u.clone());
    let largest = |direction: &P::Difference| {
        let products = curve.control_points().iter().map(|b| product(direction, b));
        products
            .reduce(OrderedScalar::max)
            .expect("a curve has a control point")
    };
    let length = |direction: &P::Difference| -> f64 {
        direction.coordinates().iter().map(Scalar::magnitude).sum()
    };
    let longest = directions.iter().map(length).fold(0.0, f64::max);
    let roundings = 3 * curve.degree() + 2 * P::DIMENSION;
    Sides::new(format!("u = {u}, {curve}")).at_most(
        "in every direction the point is at most as far as the control points",
        directions.iter().map(|d| product(d, &point)),
        directions.iter().map(largest),
        Rounding::new(roundings, longest * magnitude(curve, &u)),
    )
}

/// `bezier-convex-hull`, decided by the hull itself: the polygon contains the point b(u).
///
/// `implementation(curve, u)` must give the point at u. For exact numbers: a rounded point of a flat
/// curve need not lie in its hull.
pub fn in_convex_hull<T: Orient>(
    implementation: impl Fn(&BezierCurve<Point<T, 2>>, T) -> Point<T, 2>,
    curve: &BezierCurve<Point<T, 2>>,
    u: T,
) -> Sides<T> {
    let hull = ConvexHull::of(curve.control_points()).expect("finite control points");
    let inside = hull.contains(&implementation(curve, u.clone()));
    Sides::new(format!("u = {u}, {curve}")).equal(
        "the hull of the control points contains the point",
        [T::from_integer(i64::from(inside))],
        [T::one()],
        Rounding::none(),
    )
}

/// `bezier-bounding-box`: minᵢ bᵢ,ₖ ≤ bₖ(u) ≤ maxᵢ bᵢ,ₖ for u in the domain and every coordinate k.
///
/// `implementation(curve)` must give the box, whose sides touch control points.
///
/// # Rounding
///
/// The corners are coordinates of control points, unrounded. The rounded t stays in [0, 1]; a term of
/// the point passes 3n roundings.
pub fn bounding_box<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>) -> BoundingBox<P>,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar>
where
    P::Scalar: OrderedScalar,
{
    let bounds = implementation(curve);
    let point = curve.at(u.clone());
    let [low, high] = [bounds.low(), bounds.high()].map(|corner| corner.coordinates().to_vec());
    let rounding = Rounding::new(
        3 * curve.degree(),
        largest_coordinate(curve.control_points()),
    );
    // The other way to find the extreme coordinates: sort them.
    let sorted = |k: usize| {
        let points = curve.control_points().iter();
        let mut column: Vec<_> = points.map(|p| p.coordinates()[k].clone()).collect();
        column.sort_by(|x, y| x.partial_cmp(y).unwrap_or(std::cmp::Ordering::Equal));
        column
    };
    let columns: Vec<Vec<P::Scalar>> = (0..P::DIMENSION).map(sorted).collect();
    Sides::new(format!("u = {u}, {curve}"))
        .at_most(
            "the point is above the lower sides",
            low.clone(),
            point.coordinates().to_vec(),
            rounding,
        )
        .at_most(
            "the point is below the upper sides",
            point.coordinates().to_vec(),
            high.clone(),
            rounding,
        )
        .equal(
            "the lower sides touch a control point",
            low,
            columns.iter().map(|column| column[0].clone()),
            Rounding::none(),
        )
        .equal(
            "the upper sides touch a control point",
            high,
            columns
                .iter()
                .map(|column| column[column.len() - 1].clone()),
            Rounding::none(),
        )
}
