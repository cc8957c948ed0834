//! Mistakes with Doo–Sabin subdivision.

use cagd::affine::Affine;
use cagd::scalar::Scalar;
use cagd::subdivision::laws::Refined;
use cagd::subdivision::{
    CosineError, CosineOfTurn, DooSabin, Mesh, SurfaceScheme, doo_sabin_weights,
};
use num_traits::Zero;

/// The library's faces with other corners.
fn with_faces<P>(mesh: &Mesh<P>, rule: impl Fn(&[P]) -> Result<Vec<P>, CosineError>) -> Refined<P>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let refined = DooSabin.refine(mesh)?;
    let mut points = vec![];
    for f in mesh.connectivity().faces() {
        let corners: Vec<P> = mesh.face_points(f).cloned().collect();
        points.extend(rule(&corners)?);
    }
    Ok(Mesh::new(refined.connectivity().clone(), points)?)
}

fn combined<P: Affine>(weights: &[P::Scalar], corners: &[P]) -> Vec<P> {
    let k = corners.len();
    let corner = |i: usize| {
        P::from_fn(|axis| {
            let terms = (0..k)
                .map(|j| weights[j].clone() * corners[(i + j) % k].coordinates()[axis].clone());
            terms.fold(P::Scalar::zero(), |sum, term| sum + term)
        })
    };
    (0..k).map(corner).collect()
}

/// Goes half of the way to the centroid.
pub fn half_way_to_the_centroid<P>(corners: &[P]) -> Result<Vec<P>, CosineError>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let k = corners.len();
    let share = P::Scalar::from_ratio(1, 2 * k as i64);
    let mut weights = vec![share; k];
    weights[0] = weights[0].clone() + P::Scalar::from_ratio(1, 2);
    Ok(combined(&weights, corners))
}

/// Begins with the next corner of the face.
pub fn next_corner<P>(corners: &[P]) -> Result<Vec<P>, CosineError>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let mut weights = doo_sabin_weights::<P::Scalar>(corners.len())?;
    weights.rotate_right(1);
    Ok(combined(&weights, corners))
}

/// Forgets the 1/4 of the corner itself, and makes the sum right by dividing.
pub fn quarter_forgotten<P>(corners: &[P]) -> Result<Vec<P>, CosineError>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let mut weights = doo_sabin_weights::<P::Scalar>(corners.len())?;
    weights[0] = weights[0].clone() - P::Scalar::from_ratio(1, 4);
    let scale = P::Scalar::from_ratio(4, 3);
    let weights: Vec<_> = weights.into_iter().map(|w| w * scale.clone()).collect();
    Ok(combined(&weights, corners))
}

/// As [`half_way_to_the_centroid`], for a mesh.
pub fn mesh_half_way<P>(mesh: &Mesh<P>) -> Refined<P>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    with_faces(mesh, half_way_to_the_centroid)
}

/// As [`next_corner`], for a mesh.
pub fn mesh_next_corner<P>(mesh: &Mesh<P>) -> Refined<P>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    with_faces(mesh, next_corner)
}

/// Leaves out the faces of the vertices.
pub fn vertex_faces_forgotten<P>(mesh: &Mesh<P>) -> Refined<P>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let refined = DooSabin.refine(mesh)?;
    let old = mesh.connectivity();
    let inner = old.vertices().filter(|&v| !old.is_boundary(v)).count();
    let mut faces = refined.connectivity().face_lists();
    faces.truncate(faces.len() - inner);
    Ok(Mesh::from_faces(refined.points().to_vec(), &faces)?)
}
