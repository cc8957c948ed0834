//! Loop's scheme for triangle meshes: its stencils and its rules.

use num_traits::{One, Zero};

use super::cosine::{CosineError, CosineOfTurn};
use super::creases::{Creases, VertexRule};
use super::lattice_mask::{LatticeIndex, LatticeMask};
use super::stencil::count;
use super::{EdgeId, HalfEdgeId, Mesh, SchemeError, SurfaceScheme, VertexId};
use crate::affine::Affine;
use crate::scalar::Scalar;

/// Loop's scheme: every triangle becomes four, old vertices move towards their neighbours.
///
/// ```text
/// edge point     (3/8)(a + b) + (1/8)(c + d)       ab the edge, c and d the vertices opposite to it
/// vertex point   (1 − kβ)·v + β·Σ neighbours       k the valence of v, β from loop_beta
/// boundary       (a + b)/2 and (6v + a + b)/8      a and b the ends of the edge, or the neighbours along the boundary
/// ```
///
/// [`refine_creased`](Self::refine_creased) treats sharp edges like the boundary.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::{Loop, SurfaceScheme, VertexId, solids};
///
/// let octahedron = solids::octahedron::<BigRational>();
/// let refined = Loop.refine(&octahedron)?;
/// let mesh = refined.connectivity();
/// assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.face_count()), (18, 48, 32));
///
/// let ratio = BigRational::from_ratio;
/// assert_eq!(refined.point(VertexId(0)), &Point::new([ratio(33, 64), ratio(0, 1), ratio(0, 1)]));
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
///
/// # Errors
///
/// [`SchemeError`] for a face that is not a triangle, for a result with too many half-edges, and for a vertex
/// whose weight is irrational in exact arithmetic; rational are those of valence 3, 4 and 6.
///
/// Source: `loop1987`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Loop;

const NAME: &str = "Loop's scheme";

impl<P> SurfaceScheme<P> for Loop
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    fn name(&self) -> &'static str {
        NAME
    }

    fn refine(&self, mesh: &Mesh<P>) -> Result<Mesh<P>, SchemeError> {
        let connectivity = mesh.connectivity();
        let refined = connectivity.split_triangles()?;
        let mut points = loop_vertex_points(mesh)?;
        points.extend(connectivity.edges().map(|e| loop_edge_point(mesh, e)));
        Ok(Mesh::new(refined, points)?)
    }
}

impl Loop {
    /// One step with sharp edges and corners, and the tags of the refined mesh.
    ///
    /// The new vertex of a sharp edge is its middle; a vertex moves by its [`VertexRule`].
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::subdivision::{Creases, Loop, VertexId, solids};
    ///
    /// let octahedron = solids::octahedron::<f64>();
    /// let mesh = octahedron.connectivity();
    /// // The equator, vertices 0 to 3, is sharp.
    /// let equator = mesh.edges().filter(|&e| mesh.edge_vertices(e).iter().all(|v| v.0 < 4));
    /// let creases = Creases::new(mesh, equator, [])?;
    /// let (refined, _) = Loop.refine_creased(&octahedron, &creases)?;
    /// assert_eq!(refined.point(VertexId(0)), &Point::new([0.75, 0.0, 0.0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for one step without tags.
    pub fn refine_creased<P>(
        self,
        mesh: &Mesh<P>,
        creases: &Creases,
    ) -> Result<(Mesh<P>, Creases), SchemeError>
    where
        P: Affine,
        P::Scalar: CosineOfTurn,
    {
        let connectivity = mesh.connectivity();
        let refined = connectivity.split_triangles()?;
        let mut points = loop_vertex_points(mesh)?;
        for v in connectivity.vertices() {
            match creases.rule(connectivity, v) {
                VertexRule::Smooth => {}
                VertexRule::Crease(along) => points[v.index()] = crease_point(mesh, v, along),
                VertexRule::Corner => points[v.index()] = mesh.point(v).clone(),
            }
        }
        points.extend(connectivity.edges().map(|e| {
            if creases.is_sharp(connectivity, e) {
                middle(mesh, e)
            } else {
                loop_edge_point(mesh, e)
            }
        }));
        let tags = creases.refined(&refined);
        Ok((Mesh::new(refined, points)?, tags))
    }
}

/// The new places of all old vertices, by the smooth rule inside and by the rule of curves along the boundary.
fn loop_vertex_points<P>(mesh: &Mesh<P>) -> Result<Vec<P>, SchemeError>
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    let connectivity = mesh.connectivity();
    // One pass along the edges adds up the neighbours of all vertices.
    let mut sums = vec![P::from_fn(|_| P::Scalar::zero()); connectivity.vertex_count()];
    let mut valences = vec![0_usize; connectivity.vertex_count()];
    for e in connectivity.edges() {
        let [a, b] = connectivity.edge_vertices(e);
        for (v, neighbour) in [(a, b), (b, a)] {
            let (sum, point) = (&sums[v.index()], mesh.point(neighbour));
            sums[v.index()] = combined(&[(P::Scalar::one(), sum), (P::Scalar::one(), point)]);
            valences[v.index()] += 1;
        }
    }
    let mut weights: Vec<Option<[P::Scalar; 2]>> = vec![];
    let points = connectivity.vertices().map(|v| {
        if connectivity.is_boundary(v) {
            return Ok(crease_point(mesh, v, boundary_neighbours(mesh, v)));
        }
        let valence = valences[v.index()];
        if weights.len() <= valence {
            weights.resize(valence + 1, None);
        }
        let [own, beta] = match &weights[valence] {
            Some(known) => known.clone(),
            None => {
                let pair = vertex_weights(valence).map_err(|_| irrational(v, valence))?;
                weights[valence].insert(pair).clone()
            }
        };
        Ok(combined(&[(own, mesh.point(v)), (beta, &sums[v.index()])]))
    });
    points.collect()
}

/// The weight of a vertex and of each of its neighbours, 1 − kβ and β.
fn vertex_weights<T: CosineOfTurn>(valence: usize) -> Result<[T; 2], CosineError> {
    let beta = loop_beta::<T>(valence)?;
    Ok([T::one() - beta.clone() * count(valence), beta])
}

fn irrational(vertex: VertexId, valence: usize) -> SchemeError {
    SchemeError::Valence {
        scheme: NAME,
        vertex,
        valence,
        reason: "its weights are irrational; compute in f64, or exactly with the valences 3, 4 and 6",
    }
}

/// The edge point: 3/8 of each end and 1/8 of each opposite vertex, on the boundary the middle.
fn loop_edge_point<P: Affine>(mesh: &Mesh<P>, e: EdgeId) -> P {
    let connectivity = mesh.connectivity();
    let h = connectivity.edge_half_edge(e);
    let g = connectivity.flip(h);
    if connectivity.face(g).is_none() {
        return middle(mesh, e);
    }
    let [a, b] = [h, g].map(|h| mesh.point(connectivity.origin(h)));
    let [c, d] = [h, g].map(|h| mesh.point(connectivity.origin(connectivity.prev(h))));
    let [end, _, opposite, _] = loop_edge_weights::<P::Scalar>();
    P::from_fn(|k| {
        let x = |point: &P| point.coordinates()[k].clone();
        end.clone() * (x(a) + x(b)) + opposite.clone() * (x(c) + x(d))
    })
}

fn middle<P: Affine>(mesh: &Mesh<P>, e: EdgeId) -> P {
    let [a, b] = mesh.connectivity().edge_vertices(e).map(|v| mesh.point(v));
    a.lerp(b, P::Scalar::from_ratio(1, 2))
}

/// The neighbours of a boundary vertex along the boundary, the next one and the one before.
pub(super) fn boundary_neighbours<P: Affine>(mesh: &Mesh<P>, v: VertexId) -> [VertexId; 2] {
    let connectivity = mesh.connectivity();
    let h: HalfEdgeId = connectivity.vertex_half_edge(v);
    [
        connectivity.destination(h),
        connectivity.origin(connectivity.prev(h)),
    ]
}

fn crease_point<P: Affine>(mesh: &Mesh<P>, v: VertexId, along: [VertexId; 2]) -> P {
    let [own, one, other] = loop_boundary_weights::<P::Scalar>();
    let [a, b] = along.map(|v| mesh.point(v));
    combined(&[(own, mesh.point(v)), (one, a), (other, b)])
}

/// Σ weight · point, whatever the weights sum to.
pub(super) fn combined<P: Affine>(terms: &[(P::Scalar, &P)]) -> P {
    P::from_fn(|k| {
        terms
            .iter()
            .fold(P::Scalar::zero(), |sum, (weight, point)| {
                sum + weight.clone() * point.coordinates()[k].clone()
            })
    })
}

/// The weight β = (1/k)·(5/8 − (3/8 + cos(2π/k)/4)²) of each neighbour of an inner vertex of valence k.
///
/// The vertex itself keeps the weight 1 − kβ.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::loop_beta;
///
/// assert_eq!(loop_beta::<BigRational>(6)?, BigRational::from_ratio(1, 16));
/// assert_eq!(loop_beta::<BigRational>(3)?, BigRational::from_ratio(3, 16));
/// assert!(loop_beta::<BigRational>(5).is_err(), "not a rational number");
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Arguments
///
/// `valence`: the number k ≥ 3 of edges at the vertex. The formula makes sense for 1 and 2, too.
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or β is irrational and the type holds rational numbers only.
///
/// Source: `loop1987`.
pub fn loop_beta<T: CosineOfTurn>(valence: usize) -> Result<T, CosineError> {
    let eigenvalue = loop_subdominant_eigenvalue::<T>(valence)?;
    Ok((T::from_ratio(5, 8) - eigenvalue.clone() * eigenvalue) / count(valence))
}

/// The eigenvalue λ = 3/8 + cos(2π/k)/4 by which the neighbourhood of a vertex of valence k shrinks in each step.
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or λ is irrational and the type holds rational numbers only.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::loop_subdominant_eigenvalue;
/// assert_eq!(loop_subdominant_eigenvalue(6), Ok(0.5));
/// ```
pub fn loop_subdominant_eigenvalue<T: CosineOfTurn>(valence: usize) -> Result<T, CosineError> {
    Ok(T::from_ratio(3, 8) + T::cosine_of_turn(1, valence)? * T::from_ratio(1, 4))
}

/// The weights of an edge point: 3/8 for each end of the edge, 1/8 for each of the two opposite vertices.
///
/// ```
/// use cagd::subdivision::loop_edge_weights;
/// assert_eq!(loop_edge_weights::<f64>(), [0.375, 0.375, 0.125, 0.125]);
/// ```
#[must_use]
pub fn loop_edge_weights<T: Scalar>() -> [T; 4] {
    [3, 3, 1, 1].map(|eighths| T::from_ratio(eighths, 8))
}

/// The weights of a vertex and of its two neighbours on the boundary or along a crease: 6/8, 1/8, 1/8.
///
/// ```
/// use cagd::subdivision::loop_boundary_weights;
/// assert_eq!(loop_boundary_weights::<f64>(), [0.75, 0.125, 0.125]);
/// ```
#[must_use]
pub fn loop_boundary_weights<T: Scalar>() -> [T; 3] {
    [6, 1, 1].map(|eighths| T::from_ratio(eighths, 8))
}

/// The weight ω = 3/(8β) of a vertex in its limit position (ω·v + Σ neighbours)/(ω + k).
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::loop_limit_weight;
/// assert_eq!(loop_limit_weight::<BigRational>(4)?, BigRational::from_ratio(96, 31));
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// [`CosineError`] as for [`loop_beta`].
pub fn loop_limit_weight<T: CosineOfTurn>(valence: usize) -> Result<T, CosineError> {
    Ok(T::from_ratio(3, 8) / loop_beta(valence)?)
}

/// Loop's rules on the regular lattice Z² with edges (1, 0), (0, 1), (1, 1), as a mask.
///
/// The number at i is the weight of the old vertex 0 in the new vertex i; old vertices have even indices.
/// All weights come from [`loop_edge_weights`] and [`loop_beta`].
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{LatticeMask, loop_lattice_mask};
/// let symbol = LatticeMask::three_direction([2, 2, 2]).shifted([-2, -2]);
/// assert_eq!(loop_lattice_mask::<f64>()?, symbol);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// None in practice: 6 is one of the valences where every type knows the cosine.
pub fn loop_lattice_mask<T: CosineOfTurn>() -> Result<LatticeMask<T>, CosineError> {
    let beta = loop_beta::<T>(6)?;
    let [end, _, opposite, _] = loop_edge_weights::<T>();
    let centre: (LatticeIndex, T) = ([0, 0], T::one() - beta.clone() * T::from_integer(6));
    let around = [[1, 0], [0, 1], [1, 1]].into_iter().flat_map(|[i, j]| {
        let step = |factor: i64| [factor * i, factor * j];
        [
            (step(1), end.clone()),
            (step(-1), end.clone()),
            (step(2), beta.clone()),
            (step(-2), beta.clone()),
        ]
    });
    // New vertices on the edges opposite to the old vertex 0.
    let across = [[2, 1], [1, 2], [1, -1], [-2, -1], [-1, -2], [-1, 1]];
    let across = across.map(|index| (index, opposite.clone()));
    Ok(LatticeMask::new(
        std::iter::once(centre).chain(around).chain(across),
    ))
}
