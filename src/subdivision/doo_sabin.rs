//! Doo–Sabin subdivision: biquadratic where the mesh is regular; every corner of a face becomes a vertex.

use super::cosine::{CosineError, CosineOfTurn};
use super::stencil::count;
use super::{Mesh, SchemeError, SurfaceScheme};
use crate::affine::Affine;

const NAME: &str = "Doo–Sabin";

/// The scheme of Doo and Sabin.
///
/// The new vertex at the corner vᵢ of a face with k vertices is Σⱼ γⱼ vᵢ₊ⱼ with γ₀ = 1/4 + 5/(4k) and
/// γⱼ = (3 + 2cos(2πj/k))/(4k).
/// It has the number of the half-edge that starts at this corner.
/// The new faces are those of old faces, then those of inner edges, then those of inner vertices, each in their order.
///
/// # Examples
///
/// ```
/// use cagd::scalar::BigRational;
/// use cagd::subdivision::{DooSabin, SurfaceScheme, solids};
///
/// let refined = DooSabin.refine(&solids::cube::<BigRational>())?;
/// let mesh = refined.connectivity();
/// assert_eq!([mesh.vertex_count(), mesh.edge_count(), mesh.face_count()], [24, 48, 26]);
/// assert!(mesh.vertices().all(|v| mesh.valence(v) == 4));
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
///
/// Source: `doo-sabin1978`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DooSabin;

/// The weights γ₀, …, γ₍k₋₁₎ of the vertices of a face with k vertices, from the corner on.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::doo_sabin_weights;
/// assert_eq!(doo_sabin_weights(4), Ok(vec![9.0 / 16.0, 3.0 / 16.0, 1.0 / 16.0, 3.0 / 16.0]));
/// ```
///
/// # Arguments
///
/// `sides`: the number k ≥ 3 of vertices of the face; the formula makes sense for 1 and 2, too.
///
/// # Errors
///
/// [`CosineError`] if `sides` is 0, or a weight is irrational and the type holds rational numbers only.
pub fn doo_sabin_weights<T: CosineOfTurn>(sides: usize) -> Result<Vec<T>, CosineError> {
    T::cosine_of_turn(0, sides)?;
    (0..sides)
        .map(|j| {
            let wave = T::cosine_of_turn(i64::try_from(j).unwrap_or(i64::MAX), sides)?;
            let share = (T::from_integer(3) + wave * T::from_integer(2))
                / (count::<T>(sides) * T::from_integer(4));
            Ok(if j == 0 {
                share + T::from_ratio(1, 4)
            } else {
                share
            })
        })
        .collect()
}

/// The corners of the new face inside a face with these points.
///
/// # Errors
///
/// [`CosineError`] if there is no point, or a weight is irrational and the type holds rational numbers only.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::subdivision::doo_sabin_face;
///
/// let square = [[0.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0]].map(Point::new);
/// let smaller = doo_sabin_face(&square)?;
/// assert_eq!(smaller, [[4.0, 4.0], [12.0, 4.0], [12.0, 12.0], [4.0, 12.0]].map(Point::new));
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
pub fn doo_sabin_face<P>(corners: &[P]) -> Result<Vec<P>, CosineError>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let weights = doo_sabin_weights::<P::Scalar>(corners.len())?;
    Ok(rotated(&weights, corners))
}

/// Σⱼ weightⱼ · cornerᵢ₊ⱼ for every corner i.
fn rotated<P: Affine>(weights: &[P::Scalar], corners: &[P]) -> Vec<P> {
    let k = corners.len();
    let corner = |i: usize| {
        P::from_fn(|axis| {
            let terms = weights.iter().enumerate();
            let mut terms = terms.map(|(j, weight)| {
                weight.clone() * corners[(i + j) % k].coordinates()[axis].clone()
            });
            let first = terms.next().unwrap_or_else(num_traits::Zero::zero);
            terms.fold(first, |sum, term| sum + term)
        })
    };
    (0..k).map(corner).collect()
}

impl<P> SurfaceScheme<P> for DooSabin
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    fn name(&self) -> &'static str {
        NAME
    }

    fn refine(&self, mesh: &Mesh<P>) -> Result<Mesh<P>, SchemeError> {
        let old = mesh.connectivity();
        // A vertex inside with two edges would become a face with two corners.
        for v in old.vertices().filter(|&v| !old.is_boundary(v)) {
            let valence = old.valence(v);
            if valence < 3 {
                return Err(SchemeError::Valence {
                    scheme: NAME,
                    vertex: v,
                    valence,
                    reason: "inside a mesh at least three edges must meet; remove the vertex",
                });
            }
        }
        let mut points = Vec::with_capacity(old.corner_count());
        for f in old.faces() {
            let corners: Vec<P> = mesh.face_points(f).cloned().collect();
            points.extend(doo_sabin_face(&corners)?);
        }
        Ok(Mesh::new(old.cut_corners()?, points)?)
    }
}
