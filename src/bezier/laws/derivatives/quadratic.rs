//! Laws of quadratic curves.

use num_traits::{One, Zero};

use super::{bernstein_sum, binomial_differences};
use crate::affine::Affine;
use crate::bezier::BezierCurve;
use crate::bezier::laws::magnitude;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;

/// `bezier-quadratic-parabola`: b(t) = t²(b₂ − 2b₁ + b₀) + 2t(b₁ − b₀) + b₀, the image of (t, t²) under an affine map.
///
/// `implementation(curve, x, y)` must give the image of (x, y) under this map, for a curve of degree 2.
/// That the map is affine is seen on the corners of a parallelogram.
///
/// # Rounding
///
/// Both products, their coefficients and sums pass at most 8 roundings, the Bernstein sum 11. The
/// coefficients are at most 4 times a coordinate; x = t and y = t² sum with 1 to at most (|t| + |1 − t| + 1)².
pub fn quadratic_parabola<P: Affine>(
    implementation: impl Fn(&BezierCurve<P>, P::Scalar, P::Scalar) -> P,
    curve: &BezierCurve<P>,
    u: P::Scalar,
) -> Sides<P::Scalar> {
    let t = curve.domain().local(u.clone());
    let points: Vec<Vec<P::Scalar>> = curve
        .control_points()
        .iter()
        .map(|point| point.coordinates().to_vec())
        .collect();
    let image = |x: &P::Scalar, y: &P::Scalar| implementation(curve, x.clone(), y.clone());
    let difference = |end: &P, start: &P| end.difference(start).coordinates().to_vec();
    let (zero, one) = (P::Scalar::zero(), P::Scalar::one());
    let square = t.clone() * t.clone();
    let size = (t.magnitude() + (one.clone() - t.clone()).magnitude() + 1.0).powi(2);
    let largest = magnitude(curve, &curve.domain().start());
    let rounding = Rounding::new(20, 4.0 * largest * size);
    let on_curve = image(&t, &square);
    let axis = binomial_differences(curve.control_points(), 2).concat();
    Sides::new(format!("u = {u}, {curve}"))
        .equal(
            "the point (t, t²) of the parabola is mapped to b(t)",
            on_curve.coordinates().to_vec(),
            bernstein_sum(&one, &points, &t, P::DIMENSION),
            rounding,
        )
        .equal(
            "the axis of the parabola is mapped to b₂ − 2b₁ + b₀",
            difference(&image(&t, &(square.clone() + one.clone())), &on_curve),
            axis,
            rounding,
        )
        .equal(
            "the map keeps parallelograms",
            difference(&on_curve, &image(&t, &zero)),
            difference(&image(&zero, &square), &image(&zero, &zero)),
            rounding,
        )
}
