//! The limit position of a vertex under Catmull–Clark subdivision.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;
use cagd::subdivision::{Mesh, VertexId};

/// The limit of the inner vertex `v` of a mesh of quadrilaterals.
pub fn limit_position<T: Scalar>(mesh: &Mesh<Point<T, 3>>, v: VertexId) -> Point<T, 3> {
    let connectivity = mesh.connectivity();
    // The vector from v to another vertex.
    let to = |other: VertexId| mesh.point(other).clone() - mesh.point(v).clone();
    let mut sum: Vector<T, 3> = Vector::zeros();
    let mut valence = 0;
    for h in connectivity.vertex_ring(v) {
        //@ solution
        let neighbour = to(connectivity.destination(h));
        let opposite = to(connectivity.destination(connectivity.next(h)));
        sum += neighbour * T::from_integer(4) + opposite;
        //@ starter
        //| // Only the neighbours so far.
        //| sum += to(connectivity.destination(h));
        //@ end
        valence += 1;
    }
    //@ solution
    mesh.point(v).clone() + sum / T::from_integer(valence * (valence + 5))
    //@ starter
    //| mesh.point(v).clone() + sum / T::from_integer(valence + 1)
    //@ end
}
