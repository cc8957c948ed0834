//! misconception: the weights 16, 4, 1 of the grid serve every valence; but the weight of the vertex is k², and only 4² is 16

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
    mesh.point(v).clone() + sum / whole(16 + 5 * k)
}
