//! Wrong subdivisions.

use cagd::affine::Affine;
use cagd::bezier::{BezierCurve, bernstein};
use cagd::scalar::Scalar;
use num_traits::One;

type Pieces<P> = [BezierCurve<P>; 2];

fn curve<P: Affine>(points: impl IntoIterator<Item = P>) -> BezierCurve<P> {
    BezierCurve::new(points).expect("finite control points")
}

/// The library's subdivision.
pub fn subdivided<P: Affine>(original: &BezierCurve<P>, alpha: P::Scalar) -> Pieces<P> {
    original.subdivided(alpha).expect("finite control points")
}

/// Mixes up α and 1 − α.
pub fn parameter_reversed<P: Affine>(original: &BezierCurve<P>, alpha: P::Scalar) -> Pieces<P> {
    subdivided(original, P::Scalar::one() - alpha)
}

/// Takes the right piece from the tip to the last control point, then reads it backwards.
pub fn right_piece_reversed<P: Affine>(original: &BezierCurve<P>, alpha: P::Scalar) -> Pieces<P> {
    let [left, right] = subdivided(original, alpha);
    let backwards = right.control_points().iter().rev().cloned();
    [left, curve(backwards)]
}

/// Takes b₁ⁿ⁻ⁱ for the control point bᵢⁿ⁻ⁱ of the right piece, as the compendium prints it.
pub fn as_printed<P: Affine>(original: &BezierCurve<P>, alpha: P::Scalar) -> Pieces<P> {
    let [left, _] = subdivided(original, alpha.clone());
    let n = original.degree();
    let triangle = original.triangle(original.domain().global(alpha));
    let right = (0..=n).map(|i| {
        let index = if i == n { n } else { i.min(1) };
        triangle.point(n - i, index).clone()
    });
    [left, curve(right.collect::<Vec<_>>())]
}

/// Takes the tip's neighbours only: both pieces are halved straight lines.
pub fn straight_pieces<P: Affine>(original: &BezierCurve<P>, alpha: P::Scalar) -> Pieces<P> {
    subdivided(original, alpha).map(|piece| {
        let points = piece.control_points();
        curve([points[0].clone(), points[points.len() - 1].clone()])
    })
}

/// A Bernstein polynomial without its binomial coefficient.
pub fn without_binomial<T: Scalar>(degree: usize, index: i64, t: T) -> T {
    if index < 0 || index > degree as i64 {
        return T::zero();
    }
    let s = T::one() - t.clone();
    num_traits::pow(t, index as usize) * num_traits::pow(s, degree - index as usize)
}

/// Bₙ₋ᵢⁿ for Bᵢⁿ.
pub fn index_reversed<T: Scalar>(degree: usize, index: i64, t: T) -> T {
    bernstein(degree, degree as i64 - index, t)
}

/// The last Bernstein polynomial again for every index beyond.
pub fn not_zero_beyond<T: Scalar>(degree: usize, index: i64, t: T) -> T {
    bernstein(degree, index.min(degree as i64), t)
}

/// The polygon of corner cutting with the library's pieces, but split at `alpha`.
fn cut_at<P: Affine>(original: &BezierCurve<P>, steps: usize, alpha: &P::Scalar) -> Vec<P> {
    if steps == 0 {
        return original.control_points().to_vec();
    }
    let [left, right] = subdivided(original, alpha.clone());
    let mut vertices = cut_at(&left, steps - 1, alpha);
    vertices.extend(cut_at(&right, steps - 1, alpha).into_iter().skip(1));
    vertices
}

/// The library's polygons.
pub fn corner_cutting<P: Affine>(original: &BezierCurve<P>, steps: usize) -> Vec<P> {
    let polygon = original.corner_cutting().nth(steps).expect("no end");
    polygon.vertices().to_vec()
}

/// Splits at a third instead of the middle.
pub fn cut_at_a_third<P: Affine>(original: &BezierCurve<P>, steps: usize) -> Vec<P> {
    cut_at(original, steps, &P::Scalar::from_ratio(1, 3))
}

/// Starts with the left half, as the compendium prints P₀.
pub fn starts_with_the_left_half<P: Affine>(original: &BezierCurve<P>, steps: usize) -> Vec<P> {
    let [left, _] = original.halves();
    corner_cutting(&left, steps)
}

/// Writes the point between two pieces twice.
pub fn joints_twice<P: Affine>(original: &BezierCurve<P>, steps: usize) -> Vec<P> {
    let polygon = original.corner_cutting().nth(steps).expect("no end");
    polygon.pieces().flatten().cloned().collect()
}

/// Inserts midpoints of the legs and cuts no corner.
pub fn midpoints_only<P: Affine>(original: &BezierCurve<P>, steps: usize) -> Vec<P> {
    let mut vertices = original.control_points().to_vec();
    for _ in 0..steps {
        let half = P::Scalar::from_ratio(1, 2);
        let mut finer = vec![vertices[0].clone()];
        for leg in vertices.windows(2) {
            finer.push(leg[0].lerp(&leg[1], half.clone()));
            finer.push(leg[1].clone());
        }
        vertices = finer;
    }
    vertices
}
