//! Mistakes with limit points on creases.

use cagd::affine::Point;
use cagd::subdivision::{CatmullClark, Creases, Loop, Mesh, SchemeError, VertexId};

type Place = Point<f64, 3>;

/// The limit of a vertex.
pub type Limit = fn(&Mesh<Place>, &Creases, VertexId) -> Result<Place, SchemeError>;

/// Ignores the tags.
pub fn loop_without_tags(
    mesh: &Mesh<Place>,
    _: &Creases,
    v: VertexId,
) -> Result<Place, SchemeError> {
    Loop.limit_point(mesh, v)
}

/// Ignores the tags.
pub fn catmull_clark_without_tags(
    mesh: &Mesh<Place>,
    _: &Creases,
    v: VertexId,
) -> Result<Place, SchemeError> {
    CatmullClark.limit_position(mesh, v)
}

/// Takes every vertex for its limit.
pub fn the_vertex_itself(
    mesh: &Mesh<Place>,
    _: &Creases,
    v: VertexId,
) -> Result<Place, SchemeError> {
    Ok(*mesh.point(v))
}
