//! misconception: the limit is a product of cubic rules, so it is always divided by 36; for other valences the weights then do not sum to 1

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
        neighbours += to(connectivity.destination(h));
        opposite += to(connectivity.destination(connectivity.next(h)));
        k += 1;
    }
    let whole = T::from_integer;
    let sum = neighbours * whole(4) + opposite;
    let rest = whole(36 - k * (k + 5)) / whole(36);
    let weighted =
        mesh.point(v).clone() - (mesh.point(v).clone() - Point::new([0, 0, 0].map(whole))) * rest;
    weighted + sum / whole(36)
}
