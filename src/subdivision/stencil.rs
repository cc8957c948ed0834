//! Weighted sums of the vertices of a mesh.

use num_traits::{One, Zero};

use super::{Mesh, VertexId};
use crate::affine::Affine;
use crate::scalar::Scalar;

/// Σ weight · point over the vertices; the caller's weights sum to 1.
pub(super) fn weighted<P: Affine>(
    mesh: &Mesh<P>,
    terms: impl IntoIterator<Item = (P::Scalar, VertexId)>,
) -> P {
    let terms: Vec<_> = terms.into_iter().collect();
    P::from_fn(|k| {
        terms
            .iter()
            .fold(P::Scalar::zero(), |sum, (weight, vertex)| {
                sum + weight.clone() * mesh.point(*vertex).coordinates()[k].clone()
            })
    })
}

/// (a + w·v + b)/n for [w, n], along a crease from a over v to b.
pub(super) fn along_crease<P: Affine>(
    mesh: &Mesh<P>,
    v: VertexId,
    [a, b]: [VertexId; 2],
    [own, whole]: [i64; 2],
) -> P {
    let share = |part| P::Scalar::from_ratio(part, whole);
    weighted(mesh, [(share(1), a), (share(own), v), (share(1), b)])
}

/// The mean of some points; none have no mean, and the caller gives at least one.
pub(super) fn mean<P: Affine>(points: &[&P]) -> P {
    let share = P::Scalar::one() / count::<P::Scalar>(points.len());
    P::from_fn(|k| {
        let sum = points.iter().fold(P::Scalar::zero(), |sum, point| {
            sum + point.coordinates()[k].clone()
        });
        sum * share.clone()
    })
}

/// A number of things as a scalar.
pub(super) fn count<T: Scalar>(number: usize) -> T {
    T::from_integer(i64::try_from(number).unwrap_or(i64::MAX))
}
