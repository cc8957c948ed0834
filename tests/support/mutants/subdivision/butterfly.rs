//! Wrong ideas of the modified Butterfly scheme.

use cagd::affine::{Affine, Point};
use cagd::subdivision::laws::Refined;
use cagd::subdivision::{
    Butterfly, CosineError, CosineOfTurn, EdgeId, Mesh, SurfaceScheme, butterfly_star_weights,
};

/// Uses the cosine formula at the valences 3 and 4, too.
pub fn formula_everywhere<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    Butterfly::FORMULA_ONLY.refine(mesh)
}

/// Uses the eight points at every edge.
pub fn eight_points<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    Butterfly::UNMODIFIED.refine(mesh)
}

/// The library's result with other points for some edges.
fn with_edge_points<T: CosineOfTurn>(
    mesh: &Mesh<Point<T, 3>>,
    point: impl Fn(EdgeId, &Point<T, 3>) -> Option<Point<T, 3>>,
) -> Refined<Point<T, 3>> {
    let (connectivity, mut points) = Butterfly::MODIFIED.refine(mesh)?.into_parts();
    let old = mesh.connectivity();
    for (e, place) in old.edges().zip(&mut points[old.vertex_count()..]) {
        if let Some(other) = point(e, place) {
            *place = other;
        }
    }
    Ok(Mesh::new(connectivity, points)?)
}

fn middle<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>, e: EdgeId) -> Point<T, 3> {
    let [a, b] = mesh.connectivity().edge_vertices(e).map(|v| mesh.point(v));
    a.lerp(b, T::from_ratio(1, 2))
}

/// Puts the new vertices into the middles of the edges.
pub fn midpoints<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    with_edge_points(mesh, |e, _| Some(middle(mesh, e)))
}

/// Puts those of boundary edges into the middles.
pub fn midpoints_on_the_boundary<T: CosineOfTurn>(
    mesh: &Mesh<Point<T, 3>>,
) -> Refined<Point<T, 3>> {
    let old = mesh.connectivity();
    with_edge_points(mesh, |e, _| {
        old.is_boundary_edge(e).then(|| middle(mesh, e))
    })
}

/// Moves the point of an inner edge towards its middle where a wing is missing.
pub fn wings_left_out<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    let old = mesh.connectivity();
    with_edge_points(mesh, |e, place| {
        let h = old.edge_half_edge(e);
        let missing = [h, old.flip(h)].into_iter().any(|side| {
            [old.next(side), old.prev(side)]
                .into_iter()
                .any(|across| old.is_boundary_edge(old.edge(across)))
        });
        (missing && !old.is_boundary_edge(e))
            .then(|| place.lerp(&middle(mesh, e), T::from_ratio(1, 16)))
    })
}

/// Starts with the second neighbour.
pub fn one_neighbour_late<T: CosineOfTurn>(valence: usize) -> Result<Vec<T>, CosineError> {
    let mut weights = butterfly_star_weights(valence)?;
    weights.rotate_left(1);
    Ok(weights)
}

/// Divides the rest 1/4 equally.
pub fn equal_weights<T: CosineOfTurn>(valence: usize) -> Result<Vec<T>, CosineError> {
    Ok(vec![T::from_ratio(1, 4 * valence as i64); valence])
}

/// Leaves the data where they are and repeats the first for new vertices.
pub fn constant<T: CosineOfTurn>(data: &[T]) -> Vec<T> {
    vec![data[0].clone(); 61]
}
