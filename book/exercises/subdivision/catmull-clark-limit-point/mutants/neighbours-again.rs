//! misconception: the opposite vertex is the end of next(next(h)); but that is the next neighbour of v, one half-edge too far

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;
use cagd::subdivision::{Mesh, VertexId};

/// The limit of the inner vertex `v`.
pub fn limit_position<T: Scalar>(mesh: &Mesh<Point<T, 3>>, v: VertexId) -> Point<T, 3> {
    let connectivity = mesh.connectivity();
    let to = |other: VertexId| mesh.point(other).clone() - mesh.point(v).clone();
    let (mut neighbours, mut opposite) = (Vector::<T, 3>::zeros(), Vector::<T, 3>::zeros());
    let mut k = 0;
    for h in connectivity.vertex_ring(v) {
        let next = connectivity.next(h);
        neighbours += to(connectivity.destination(h));
        opposite += to(connectivity.destination(connectivity.next(next)));
        k += 1;
    }
    let whole = T::from_integer;
    let sum = neighbours * whole(4) + opposite;
    mesh.point(v).clone() + sum / whole(k * (k + 5))
}
