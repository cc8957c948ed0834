//! Laws of the Bernstein form: the curve as a sum, and the change of basis.

mod basis;
mod form;

pub use basis::*;
pub use form::*;

use num_traits::Zero;

use crate::affine::Affine;

/// Coordinate k of the sum of the points with these weights.
fn weighted_sum<P: Affine>(weights: &[P::Scalar], points: &[P], k: usize) -> P::Scalar {
    std::iter::zip(weights, points).fold(P::Scalar::zero(), |sum, (weight, point)| {
        sum + weight.clone() * point.coordinates()[k].clone()
    })
}
