//! The modified Butterfly scheme for triangle meshes: its stencils and its rules.

use super::cosine::{CosineError, CosineOfTurn};
use super::loop_scheme::{boundary_neighbours, combined};
use super::{HalfEdgeId, HalfEdgeMesh, Mesh, SchemeError, SurfaceScheme, VertexId};
use crate::affine::Affine;
use crate::scalar::Scalar;

/// A Butterfly scheme: every triangle becomes four, old vertices stay.
///
/// The new vertex of an edge whose ends both have valence 6 comes from the eight-point stencil ([`butterfly_weights`]).
/// At an end of another valence it comes from the star of that end ([`butterfly_star_weights`]); the mean of both stars
/// if both ends are such.
///
/// # Boundary
///
/// The new vertex of a boundary edge is that of the four-point scheme along the boundary, −1/16, 9/16, 9/16, −1/16.
/// A boundary vertex counts as regular, and a wing that would lie outside is replaced by the fourth corner of
/// a parallelogram, so that all points of a plane stay in it.
/// Smoothness at the boundary is not claimed; `zorin1996` has more elaborate rules there.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::{Butterfly, SurfaceScheme, VertexId, solids};
///
/// let icosahedron = solids::icosahedron::<f64>();
/// let refined = Butterfly::MODIFIED.refine(&icosahedron)?;
/// assert_eq!(refined.connectivity().vertex_count(), 12 + 30);
/// assert_eq!(refined.point(VertexId(3)), icosahedron.point(VertexId(3)), "the scheme interpolates");
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
///
/// Source: `zorin1996`, `dyn1990`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Butterfly {
    star: StarRule,
}

/// What a Butterfly scheme does at a vertex whose valence is not 6.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum StarRule {
    /// The weights for 3, 4, and 5 or more.
    Modified,
    /// The eight-point stencil everywhere.
    EightPoints,
    /// The cosine formula, also for 3 and 4.
    FormulaOnly,
}

const NAME: &str = "the Butterfly scheme";

impl Butterfly {
    /// The modified scheme, smooth at vertices of every valence.
    pub const MODIFIED: Self = Self {
        star: StarRule::Modified,
    };
    /// The eight-point stencil at every edge. It is not smooth at vertices of valence 3 and of valence 8 or more.
    pub const UNMODIFIED: Self = Self {
        star: StarRule::EightPoints,
    };
    /// The cosine formula for all valences but 6. It is wrong for 3 and 4: for counterexamples only.
    pub const FORMULA_ONLY: Self = Self {
        star: StarRule::FormulaOnly,
    };

    /// The weights of the neighbours of a vertex, the first being the other end of the edge; none where the eight points count.
    fn star<T: CosineOfTurn>(
        self,
        mesh: &HalfEdgeMesh,
        v: VertexId,
    ) -> Result<Option<Vec<T>>, SchemeError> {
        if self.star == StarRule::EightPoints || mesh.is_boundary(v) {
            return Ok(None);
        }
        let valence = mesh.valence(v);
        if valence == 6 {
            return Ok(None);
        }
        let weights = match self.star {
            StarRule::FormulaOnly => butterfly_cosine_formula(valence),
            _ => butterfly_star_weights(valence),
        };
        weights.map(Some).map_err(|_| SchemeError::Valence {
            scheme: NAME,
            vertex: v,
            valence,
            reason:
                "its weights are irrational; compute in f64, or exactly with the valences 3, 4 and 6",
        })
    }
}

impl<P> SurfaceScheme<P> for Butterfly
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
        let stars = connectivity
            .vertices()
            .map(|v| self.star::<P::Scalar>(connectivity, v))
            .collect::<Result<Vec<_>, _>>()?;
        let mut points = mesh.points().to_vec();
        for e in connectivity.edges() {
            let h = connectivity.edge_half_edge(e);
            let g = connectivity.flip(h);
            let star = |h: HalfEdgeId| {
                let weights = stars[connectivity.origin(h).index()].as_ref();
                weights.map(|weights| star_point(mesh, h, weights))
            };
            points.push(if connectivity.face(g).is_none() {
                boundary_point(mesh, h)
            } else {
                match (star(h), star(g)) {
                    (None, None) => eight_points(mesh, h),
                    (Some(point), None) | (None, Some(point)) => point,
                    (Some(one), Some(other)) => one.lerp(&other, P::Scalar::from_ratio(1, 2)),
                }
            });
        }
        Ok(Mesh::new(refined, points)?)
    }
}

/// The new vertex on the edge of `h`, from the star of its origin.
fn star_point<P: Affine>(mesh: &Mesh<P>, h: HalfEdgeId, weights: &[P::Scalar]) -> P {
    let connectivity = mesh.connectivity();
    let centre = (
        butterfly_centre_weight(),
        mesh.point(connectivity.origin(h)),
    );
    let mut terms = vec![centre];
    let mut spoke = h;
    for weight in weights {
        let neighbour = mesh.point(connectivity.destination(spoke));
        terms.push((weight.clone(), neighbour));
        spoke = connectivity.around_origin(spoke);
    }
    combined(&terms)
}

/// The new vertex on the edge of `h`, from the eight-point stencil.
fn eight_points<P: Affine>(mesh: &Mesh<P>, h: HalfEdgeId) -> P {
    let connectivity = mesh.connectivity();
    let [end, opposite, wing] = butterfly_weights::<P::Scalar>();
    let origin = |h: HalfEdgeId| mesh.point(connectivity.origin(h));
    let mut terms = vec![];
    let mut outside = vec![];
    for side in [h, connectivity.flip(h)] {
        let (next, prev) = (connectivity.next(side), connectivity.prev(side));
        terms.push((end.clone(), origin(side)));
        terms.push((opposite.clone(), origin(prev)));
        for across in [next, prev] {
            let beyond = connectivity.flip(across);
            match connectivity.face(beyond) {
                Some(_) => terms.push((wing.clone(), origin(connectivity.prev(beyond)))),
                None => {
                    // The fourth corner of the parallelogram on the other side of the edge.
                    let corner = origin(connectivity.prev(across));
                    let [a, b] = [across, beyond].map(origin);
                    let one = P::Scalar::from_ratio(1, 1);
                    outside.push(combined(&[
                        (one.clone(), a),
                        (one.clone(), b),
                        (-one, corner),
                    ]));
                }
            }
        }
    }
    terms.extend(outside.iter().map(|point| (wing.clone(), point)));
    combined(&terms)
}

/// The new vertex on a boundary edge, from the four-point scheme.
fn boundary_point<P: Affine>(mesh: &Mesh<P>, h: HalfEdgeId) -> P {
    let connectivity = mesh.connectivity();
    // The boundary runs from b to a.
    let [a, b] = [h, connectivity.flip(h)].map(|h| connectivity.origin(h));
    let [after, _] = boundary_neighbours(mesh, a);
    let [_, before] = boundary_neighbours(mesh, b);
    let [inner, outer] = [9, -1].map(|w| P::Scalar::from_ratio(w, 16));
    combined(&[
        (inner.clone(), mesh.point(a)),
        (inner, mesh.point(b)),
        (outer.clone(), mesh.point(after)),
        (outer, mesh.point(before)),
    ])
}

/// The weights of the eight-point stencil: an end of the edge 1/2, a vertex opposite to it 1/8, a wing −1/16.
///
/// ```text
///   wing ──── opposite ──── wing
///       ╲     ╱    ╲      ╱
///        ╲   ╱      ╲    ╱
///         end ────── end
///        ╱   ╲      ╱    ╲
///       ╱     ╲    ╱      ╲
///   wing ──── opposite ──── wing
/// ```
///
/// ```
/// use cagd::subdivision::butterfly_weights;
/// let [end, opposite, wing] = butterfly_weights::<f64>();
/// assert_eq!(2.0 * end + 2.0 * opposite + 4.0 * wing, 1.0);
/// ```
///
/// Source: `dyn1990`.
#[must_use]
pub fn butterfly_weights<T: Scalar>() -> [T; 3] {
    [8, 2, -1].map(|sixteenths| T::from_ratio(sixteenths, 16))
}

/// The weights s₀, …, s₍k₋₁₎ of the neighbours of a vertex of valence k ≠ 6 in the new point on the edge to neighbour 0.
///
/// The vertex itself has the weight 3/4 ([`butterfly_centre_weight`]), and the s_j sum to 1/4.
///
/// ```text
/// k ≥ 5:   s_j = (1/k)(1/4 + cos(2πj/k) + cos(4πj/k)/2)
/// k = 4:   3/8, 0, −1/8, 0
/// k = 3:   5/12, −1/12, −1/12
/// ```
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::butterfly_star_weights;
///
/// let ratio = BigRational::from_ratio;
/// assert_eq!(butterfly_star_weights::<BigRational>(4)?, [ratio(3, 8), ratio(0, 1), ratio(-1, 8), ratio(0, 1)]);
/// assert_eq!(butterfly_star_weights::<BigRational>(3)?, [ratio(5, 12), ratio(-1, 12), ratio(-1, 12)]);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or a weight is irrational and the type holds rational numbers only.
///
/// Source: `zorin1996`.
pub fn butterfly_star_weights<T: CosineOfTurn>(valence: usize) -> Result<Vec<T>, CosineError> {
    let list = |numerators: &[i64], denominator| {
        let weights = numerators.iter().map(|&n| T::from_ratio(n, denominator));
        Ok(weights.collect())
    };
    match valence {
        3 => list(&[5, -1, -1], 12),
        4 => list(&[3, 0, -1, 0], 8),
        _ => butterfly_cosine_formula(valence),
    }
}

/// The formula s_j = (1/k)(1/4 + cos(2πj/k) + cos(4πj/k)/2) at any valence, also where it gives the wrong weights.
///
/// It is right for k ≥ 5. Use [`butterfly_star_weights`].
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::butterfly_cosine_formula;
/// let ratio = BigRational::from_ratio;
/// let wrong = [ratio(7, 12), ratio(-1, 6), ratio(-1, 6)];
/// assert_eq!(butterfly_cosine_formula::<BigRational>(3)?, wrong);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
///
/// # Errors
///
/// [`CosineError`] if `valence` is 0, or a weight is irrational and the type holds rational numbers only.
pub fn butterfly_cosine_formula<T: CosineOfTurn>(valence: usize) -> Result<Vec<T>, CosineError> {
    // Asks for the first cosine even where no weight is wanted, so that valence 0 is refused.
    T::cosine_of_turn(0, valence)?;
    let count = i64::try_from(valence).unwrap_or(i64::MAX);
    (0..count)
        .map(|j| {
            let once = T::cosine_of_turn(j, valence)?;
            let twice = T::cosine_of_turn(2 * j, valence)?;
            let sum = T::from_ratio(1, 4) + once + twice * T::from_ratio(1, 2);
            Ok(sum / T::from_integer(count))
        })
        .collect()
}

/// The weight 3/4 of the extraordinary vertex itself.
///
/// ```
/// use cagd::subdivision::{butterfly_centre_weight, butterfly_star_weights};
/// let star: f64 = butterfly_star_weights::<f64>(3)?.iter().sum();
/// assert!((butterfly_centre_weight::<f64>() + star - 1.0).abs() < 1e-15);
/// # Ok::<(), cagd::subdivision::CosineError>(())
/// ```
#[must_use]
pub fn butterfly_centre_weight<T: Scalar>() -> T {
    T::from_ratio(3, 4)
}
