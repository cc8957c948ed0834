//! Wrong ideas of the modified Butterfly scheme.

use cagd::affine::{Affine, Point};
use cagd::subdivision::laws::Refined;
use cagd::subdivision::{
    Butterfly, CosineError, CosineOfTurn, Mesh, SurfaceScheme, butterfly_star_weights,
};

/// Uses the cosine formula at the valences 3 and 4, too.
pub fn formula_everywhere<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    Butterfly::FORMULA_ONLY.refine(mesh)
}

/// Uses the eight points at every edge.
pub fn eight_points<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    Butterfly::UNMODIFIED.refine(mesh)
}

/// Puts the new vertices into the middles of the edges.
pub fn midpoints<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    let refined = Butterfly::MODIFIED.refine(mesh)?;
    let old = mesh.connectivity();
    let mut points = mesh.points().to_vec();
    points.extend(old.edges().map(|e| {
        let [a, b] = old.edge_vertices(e).map(|v| mesh.point(v));
        a.lerp(b, T::from_ratio(1, 2))
    }));
    Ok(Mesh::new(refined.connectivity().clone(), points)?)
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
