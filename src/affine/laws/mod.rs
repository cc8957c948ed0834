//! One law per theorem, lemma, definition and example of the chapter that claims something, in the sections of its text.
//!
//! Bounds for rounding are stated with u = 2⁻⁵³ as in [`law`](crate::law).

mod areas;
mod barycentric;
mod combinations;
mod convexity;
mod magnitudes;
mod maps;
mod points_and_vectors;

pub use areas::*;
pub use barycentric::*;
pub use combinations::*;
pub use convexity::*;
pub use maps::*;
pub use points_and_vectors::*;

use super::Affine;
use crate::scalar::Scalar;

/// The largest absolute value of a coordinate.
fn largest<'a, P: Affine>(points: impl IntoIterator<Item = &'a P>) -> f64 {
    points
        .into_iter()
        .flat_map(|point| point.coordinates())
        .map(Scalar::magnitude)
        .fold(0.0, f64::max)
}

/// The sum of the weights, and that of their absolute values.
fn sums<'a, T: Scalar>(weights: impl IntoIterator<Item = &'a T>) -> (T, f64) {
    weights
        .into_iter()
        .fold((T::zero(), 0.0), |(sum, magnitude), weight| {
            (sum + weight.clone(), magnitude + weight.magnitude())
        })
}

/// 1 for a claim that is true, 0 for one that is false.
fn indicator<T: Scalar>(holds: bool) -> T {
    T::from_integer(i64::from(holds))
}

/// Weights and points, for whoever reads a violation.
fn listed<P: Affine>(terms: &[(P::Scalar, P)]) -> String {
    let terms: Vec<String> = terms
        .iter()
        .map(|(weight, point)| format!("{weight} · {point:?}"))
        .collect();
    terms.join(", ")
}
