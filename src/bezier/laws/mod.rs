//! One law per theorem, lemma, corollary and algorithm of the chapter, in the sections of its text.
//!
//! Bounds for rounding are stated with u = 2⁻⁵³ as in [`law`](crate::law).

mod bernstein;
mod blossom;
mod bounds;
mod de_casteljau;
mod derivatives;
mod elevation;
mod intersection;
mod representation;
mod shape;
mod subdivision;

pub use bernstein::*;
pub use blossom::*;
pub use bounds::*;
pub use de_casteljau::*;
pub use derivatives::*;
pub use elevation::*;
pub use intersection::*;
pub use representation::*;
pub use shape::*;
pub use subdivision::*;

use super::BezierCurve;
use crate::affine::Affine;
use crate::scalar::Scalar;

/// A bound for Σ|Bᵢⁿ(t)|·|bᵢ| in every coordinate: max|bᵢ|·(|t| + |1 − t|)ⁿ.
///
/// It is what the terms of any way to evaluate the curve sum to at most.
pub(crate) fn magnitude<P: Affine>(curve: &BezierCurve<P>, u: &P::Scalar) -> f64 {
    let t = curve.domain().local(u.clone());
    let s = P::Scalar::from_integer(1) - t.clone();
    largest_coordinate(curve.control_points())
        * (t.magnitude() + s.magnitude()).powi(curve.degree() as i32)
}

/// The largest absolute value of a coordinate.
pub(crate) fn largest_coordinate<P: Affine>(points: &[P]) -> f64 {
    points
        .iter()
        .flat_map(|point| point.coordinates())
        .map(Scalar::magnitude)
        .fold(0.0, f64::max)
}

/// The coordinates of many points, one after the other.
pub(crate) fn flat<'a, P: Affine>(points: impl IntoIterator<Item = &'a P>) -> Vec<P::Scalar> {
    points
        .into_iter()
        .flat_map(|point| point.coordinates().to_vec())
        .collect()
}
