//! Limit positions, tangents and normals of Loop's scheme.

use num_traits::One as _;

use super::cosine::{CosineError, CosineOfTurn};
use super::creases::{Creases, VertexRule};
use super::loop_scheme::{Loop, boundary_neighbours, loop_limit_weight};
use super::stencil::{along_crease, count, weighted};
use super::{Mesh, SchemeError, VertexId};
use crate::affine::{Affine, Point, Vector};

/// The weights of the neighbours of an inner vertex in a tangent vector: cos(2π(i − j)/k) for neighbour i.
///
/// The tangent points towards neighbour j.
/// Two different ones span the tangent plane, for they are combinations of Σ cos(2πi/k)·nᵢ and Σ sin(2πi/k)·nᵢ;
/// without sines they stay rational for the valences 3, 4 and 6.
///
/// ```
/// use cagd::subdivision::loop_tangent_weights;
/// assert_eq!(loop_tangent_weights(4, 0), Ok(vec![1.0, 0.0, -1.0, 0.0]));
/// assert_eq!(loop_tangent_weights(4, 1), Ok(vec![0.0, 1.0, 0.0, -1.0]));
/// ```
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or a weight is irrational and the type holds rational numbers only.
pub fn loop_tangent_weights<T: CosineOfTurn>(
    valence: usize,
    towards: usize,
) -> Result<Vec<T>, CosineError> {
    T::cosine_of_turn(0, valence)?;
    let whole = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    (0..valence)
        .map(|i| T::cosine_of_turn(whole(i) - whole(towards), valence))
        .collect()
}

/// The weights of a boundary vertex and of its neighbours in the tangent vector across the boundary.
///
/// The first is that of the vertex, the others follow counterclockwise from one boundary edge to the other.
/// With c = cos(π/(n − 1)) for n neighbours, the inner ones have the Chebyshev polynomials U₀(c), U₁(c), … = sin(iθ)/sin θ,
/// the two on the boundary −c/((1 − c)(1 + 2c)), the vertex the rest that makes the sum 0.
/// It is the left eigenvector for the eigenvalue 3/8 + c/4; a vertex with two neighbours has −2, 1, 1.
///
/// ```
/// use cagd::subdivision::loop_boundary_tangent_weights;
/// assert_eq!(loop_boundary_tangent_weights(4), Ok(vec![-1.0, -0.5, 1.0, 1.0, -0.5]));
/// ```
///
/// # Errors
///
/// [`CosineError`] if there are fewer than two neighbours, or a weight is irrational and the type holds rational numbers only.
pub fn loop_boundary_tangent_weights<T: CosineOfTurn>(
    neighbours: usize,
) -> Result<Vec<T>, CosineError> {
    let one = T::one();
    if neighbours == 2 {
        return Ok(vec![T::from_integer(-2), one.clone(), one]);
    }
    let c = T::cosine_of_turn(1, 2 * neighbours.saturating_sub(1))?;
    let two_c = c.clone() + c.clone();
    let outer = -c.clone() / ((one.clone() - c) * (one.clone() + two_c.clone()));
    let mut inner = vec![];
    let (mut before, mut current) = (T::zero(), one);
    for _ in 0..neighbours.saturating_sub(2) {
        let next = two_c.clone() * current.clone() - before;
        inner.push(current.clone());
        (before, current) = (current, next);
    }
    let sum = inner
        .iter()
        .fold(outer.clone() + outer.clone(), |sum, w| sum + w.clone());
    let mut weights = vec![-sum, outer.clone()];
    weights.extend(inner);
    weights.push(outer);
    Ok(weights)
}

impl Loop {
    /// Where a vertex comes to lie in the limit.
    ///
    /// Inside (ω·v + Σ neighbours)/(ω + k) with ω = 3/(8β), on the boundary (4v + a + b)/6 with the neighbours along it.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::scalar::{BigRational, Scalar};
    /// use cagd::subdivision::{Loop, VertexId, solids};
    ///
    /// let limit = Loop.limit_point(&solids::octahedron::<BigRational>(), VertexId(0))?;
    /// let ratio = BigRational::from_ratio;
    /// assert_eq!(limit, Point::new([ratio(24, 55), ratio(0, 1), ratio(0, 1)]));
    /// # Ok::<(), cagd::subdivision::SchemeError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SchemeError`] if a weight is irrational and the type holds rational numbers only.
    ///
    /// # Panics
    ///
    /// If the mesh has no such vertex.
    pub fn limit_point<P>(self, mesh: &Mesh<P>, v: VertexId) -> Result<P, SchemeError>
    where
        P: Affine,
        P::Scalar: CosineOfTurn,
    {
        let connectivity = mesh.connectivity();
        if connectivity.is_boundary(v) {
            return Ok(along_crease(mesh, v, boundary_neighbours(mesh, v), [4, 6]));
        }
        let valence = connectivity.valence(v);
        let omega = loop_limit_weight::<P::Scalar>(valence).map_err(|_| irrational(v, valence))?;
        let share = P::Scalar::one() / (omega.clone() + count(valence));
        let neighbours = connectivity.neighbours(v).map(|n| (share.clone(), n));
        let own = (omega * share.clone(), v);
        Ok(weighted(mesh, std::iter::once(own).chain(neighbours)))
    }

    /// Where a vertex comes to lie in the limit of [`refine_creased`](Loop::refine_creased).
    ///
    /// A corner stays, and a vertex of a crease goes to (4v + a + b)/6 with its neighbours along it.
    /// What touches no sharp edge goes where it goes without tags: sharp edges farther away do not reach it.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::subdivision::{Creases, Loop, VertexId, solids};
    ///
    /// let octahedron = solids::octahedron::<f64>();
    /// let mesh = octahedron.connectivity();
    /// let equator = mesh.edges().filter(|&e| mesh.edge_vertices(e).iter().all(|v| v.0 < 4));
    /// let creases = Creases::new(mesh, equator, [])?;
    /// let limit = Loop.limit_point_creased(&octahedron, &creases, VertexId(0))?;
    /// assert!((limit - Point::new([2.0 / 3.0, 0.0, 0.0])).amax() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`limit_point`](Self::limit_point), and [`SchemeError::CreaseEnd`] where exactly one sharp edge ends.
    ///
    /// # Panics
    ///
    /// If the mesh has no such vertex.
    pub fn limit_point_creased<P>(
        self,
        mesh: &Mesh<P>,
        creases: &Creases,
        v: VertexId,
    ) -> Result<P, SchemeError>
    where
        P: Affine,
        P::Scalar: CosineOfTurn,
    {
        let connectivity = mesh.connectivity();
        match creases.rule(connectivity, v) {
            VertexRule::Corner => Ok(mesh.point(v).clone()),
            VertexRule::Crease(ends) => Ok(along_crease(mesh, v, ends, [4, 6])),
            VertexRule::Smooth if creases.is_dart(connectivity, v) => Err(SchemeError::CreaseEnd {
                scheme: "Loop's scheme",
                vertex: v,
            }),
            VertexRule::Smooth => self.limit_point(mesh, v),
        }
    }

    /// Two vectors that span the tangent plane of the limit surface at a vertex, if they are independent.
    ///
    /// Inside they point towards the first two neighbours, in the order of [`vertex_ring`](super::HalfEdgeMesh::vertex_ring);
    /// at the boundary one runs along it and the other across. Their cross product points to the outside.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Vector;
    /// use cagd::subdivision::{Loop, VertexId, solids};
    ///
    /// let [first, second] = Loop.limit_tangents(&solids::octahedron::<f64>(), VertexId(4))?;
    /// assert_eq!(first.cross(&second).normalize(), Vector::from([0.0, 0.0, 1.0]));
    /// # Ok::<(), cagd::subdivision::SchemeError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SchemeError`] if a weight is irrational and the type holds rational numbers only.
    ///
    /// # Panics
    ///
    /// If the mesh has no such vertex.
    pub fn limit_tangents<T: CosineOfTurn>(
        self,
        mesh: &Mesh<Point<T, 3>>,
        v: VertexId,
    ) -> Result<[Vector<T, 3>; 2], SchemeError> {
        let connectivity = mesh.connectivity();
        let ring: Vec<VertexId> = connectivity.neighbours(v).collect();
        let own = mesh.point(v);
        // The weights sum to 0, so a vector may be computed from the differences to the vertex.
        let sum = |weights: &[T]| {
            let terms = weights.iter().zip(&ring);
            terms.fold(Vector::zeros(), |sum: Vector<T, 3>, (weight, &n)| {
                sum + (mesh.point(n).clone() - own.clone()) * weight.clone()
            })
        };
        let refused = |_| irrational(v, ring.len());
        if connectivity.is_boundary(v) {
            let weights = loop_boundary_tangent_weights::<T>(ring.len()).map_err(refused)?;
            let ends = ring.first().zip(ring.last());
            let along = ends.map_or_else(Vector::zeros, |(&first, &last)| {
                mesh.point(first).clone() - mesh.point(last).clone()
            });
            return Ok([along, sum(&weights[1..])]);
        }
        let mut tangents = [Vector::zeros(), Vector::zeros()];
        for (towards, tangent) in tangents.iter_mut().enumerate() {
            *tangent = sum(&loop_tangent_weights(ring.len(), towards).map_err(refused)?);
        }
        Ok(tangents)
    }
}

fn irrational(vertex: VertexId, valence: usize) -> SchemeError {
    SchemeError::Valence {
        scheme: "the limit of Loop's scheme",
        vertex,
        valence,
        reason: "its weights are irrational; compute in f64, or exactly with the valences 3, 4 and 6",
    }
}
