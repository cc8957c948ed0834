//! Kobbelt's scheme: the four-point scheme along rows and columns, and a virtual point where a mesh has none.

use num_traits::Zero;

use super::stencil::{count, weighted};
use super::{FaceId, HalfEdgeId, HalfEdgeMesh, Mesh, SchemeError, SurfaceScheme, VertexId};
use crate::affine::Affine;
use crate::scalar::Scalar;

const NAME: &str = "Kobbelt";

/// The interpolating scheme of Kobbelt for closed meshes of quadrilaterals.
///
/// Old vertices stay. An edge point is 9/16 (p + q) − 1/16 (p′ + q′) with the vertices beyond p and q; a face point is the
/// four-point rule across the face. At a vertex of valence n ≠ 4 the vertex beyond is [`kobbelt_virtual_point`].
///
/// # Examples
///
/// ```
/// use cagd::scalar::BigRational;
/// use cagd::subdivision::{CatmullClark, Kobbelt, SurfaceScheme, solids};
///
/// // All vertices of a cube are extraordinary; one split separates them.
/// let cube = solids::cube::<BigRational>();
/// assert!(Kobbelt.refine(&cube).is_err());
/// let mesh = CatmullClark.refine(&cube)?;
/// let refined = Kobbelt.refine(&mesh)?;
/// assert_eq!(&refined.points()[..26], mesh.points(), "it interpolates");
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
///
/// Source: `kobbelt1996`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Kobbelt;

/// The weights of the four-point rule, −1/16, 9/16, 9/16, −1/16, which the scheme applies along rows and columns.
///
/// ```
/// use cagd::subdivision::kobbelt_weights;
/// assert_eq!(kobbelt_weights::<f64>().iter().sum::<f64>(), 1.0);
/// ```
#[must_use]
pub fn kobbelt_weights<T: Scalar>() -> [T; 4] {
    [-1, 9, 9, -1].map(|part| T::from_ratio(part, 16))
}

/// The inner and the outer weight of the rule.
fn rule<T: Scalar>() -> [T; 2] {
    let [outer, inner, ..] = kobbelt_weights();
    [inner, outer]
}

/// The weights of the virtual point beyond a vertex of valence n on the edge to neighbour 0: those of its neighbours
/// l₀, …, and those of the opposite vertices q₀, ….
///
/// ```text
/// v₀ = 4/n Σ lⱼ − (l₋₁ + l₀ + l₁) + 1/9 (q₋₂ + q₋₁ + q₀ + q₁) − 4/(9n) Σ qⱼ
/// ```
///
/// # Examples
///
/// ```
/// use cagd::subdivision::kobbelt_virtual_weights;
/// let [neighbours, opposite] = kobbelt_virtual_weights::<f64>(4);
/// assert_eq!(neighbours, [0.0, 0.0, 1.0, 0.0], "the vertex straight beyond");
/// assert_eq!(opposite, [0.0; 4]);
/// ```
///
/// # Arguments
///
/// `valence`: n ≥ 3. Without neighbours there is no weight.
#[must_use]
pub fn kobbelt_virtual_weights<T: Scalar>(valence: usize) -> [Vec<T>; 2] {
    if valence == 0 {
        return [vec![], vec![]];
    }
    let n = count::<T>(valence);
    let ninth = T::from_ratio(1, 9);
    // `nearby` counts from neighbour −2 on.
    let shares = |all: T, part: T, nearby: &[usize]| {
        let mut weights = vec![all; valence];
        for shift in nearby {
            let weight = &mut weights[(shift + 2 * valence - 2) % valence];
            *weight = weight.clone() + part.clone();
        }
        weights
    };
    let four = T::from_integer(4);
    [
        shares(four.clone() / n.clone(), -T::one(), &[1, 2, 3]),
        shares(-(four * ninth.clone() / n), ninth, &[0, 1, 2, 3]),
    ]
}

/// The virtual point beyond a vertex on the edge to `neighbours[0]`; see [`kobbelt_virtual_weights`].
///
/// # Examples
///
/// ```
/// use cagd::subdivision::kobbelt_virtual_point;
/// // On a regular grid it is the vertex straight beyond.
/// assert_eq!(kobbelt_virtual_point(&[1.0, 5.0, -1.0, -5.0], &[6.0, 4.0, -6.0, -4.0]), -1.0);
/// ```
///
/// # Arguments
///
/// `neighbours`: l₀, …, counterclockwise; `opposite`: qⱼ in the face of lⱼ and lⱼ₊₁. Both have the same length n ≥ 3;
/// what is beyond the shorter one is ignored.
#[must_use]
pub fn kobbelt_virtual_point<P: Affine>(neighbours: &[P], opposite: &[P]) -> P {
    let weights = kobbelt_virtual_weights::<P::Scalar>(neighbours.len().min(opposite.len()));
    P::from_fn(|axis| {
        weights
            .iter()
            .zip([neighbours, opposite])
            .flat_map(|(weights, points)| weights.iter().zip(points))
            .fold(P::Scalar::zero(), |sum, (weight, point)| {
                sum + weight.clone() * point.coordinates()[axis].clone()
            })
    })
}

/// The neighbours of a vertex and the opposite vertices, counterclockwise from half-edge `h` on.
fn star(mesh: &HalfEdgeMesh, h: HalfEdgeId) -> [Vec<VertexId>; 2] {
    let mut ring = vec![h];
    let mut around = mesh.around_origin(h);
    while around != h {
        ring.push(around);
        around = mesh.around_origin(around);
    }
    let ends = ring.iter().map(|&h| mesh.destination(h));
    let opposite = ring.iter().map(|&h| mesh.destination(mesh.next(h)));
    [ends.collect(), opposite.collect()]
}

/// The point beyond the origin of `h` on the line of its edge.
fn beyond<P: Affine>(mesh: &Mesh<P>, h: HalfEdgeId) -> P {
    let star = star(mesh.connectivity(), h);
    let [neighbours, opposite] = star.map(|vertices| {
        let points = vertices.into_iter().map(|v| mesh.point(v).clone());
        points.collect::<Vec<P>>()
    });
    match neighbours.len() {
        4 => neighbours[2].clone(),
        _ => kobbelt_virtual_point(&neighbours, &opposite),
    }
}

fn edge_point<P: Affine>(mesh: &Mesh<P>, h: HalfEdgeId) -> P {
    let old = mesh.connectivity();
    let g = old.flip(h);
    let ends = [old.origin(h), old.origin(g)].map(|v| mesh.point(v));
    let outer = [beyond(mesh, h), beyond(mesh, g)];
    let [inner_weight, outer_weight] = rule::<P::Scalar>();
    P::from_fn(|axis| {
        let at = |point: &P| point.coordinates()[axis].clone();
        (at(ends[0]) + at(ends[1])) * inner_weight.clone()
            + (at(&outer[0]) + at(&outer[1])) * outer_weight.clone()
    })
}

/// The face point, by way of the edge points at both sides of the edge of `h` and beyond.
///
/// `h` starts at the extraordinary vertex of the face, if there is one.
fn face_point<P: Affine>(mesh: &Mesh<P>, h: HalfEdgeId, face: FaceId) -> P {
    let old = mesh.connectivity();
    let [alpha, beta] = rule::<P::Scalar>();
    let [inner, side, corner] = [
        alpha.clone() * alpha.clone(),
        alpha * beta.clone(),
        beta.clone() * beta,
    ];
    let mut terms = vec![];
    for g in old.face_half_edges(face) {
        terms.push((inner.clone(), old.origin(g)));
        let [neighbours, opposite] = star(old, g);
        let n = neighbours.len();
        terms.push((side.clone(), neighbours[n - 1]));
        terms.push((corner.clone(), opposite[n - 2]));
        if g != h {
            terms.push((side.clone(), neighbours[2]));
        }
    }
    let [rest, start] = [weighted(mesh, terms), beyond(mesh, h)];
    P::from_fn(|axis| {
        let at = |point: &P| point.coordinates()[axis].clone();
        at(&rest) + side.clone() * at(&start)
    })
}

/// The half-edge of a face at its extraordinary vertex, or its first one; the scheme needs at most one such vertex.
fn begin(mesh: &HalfEdgeMesh, face: FaceId) -> Result<HalfEdgeId, SchemeError> {
    let extraordinary = |h: &HalfEdgeId| mesh.valence(mesh.origin(*h)) != 4;
    let mut found = mesh.face_half_edges(face).filter(extraordinary);
    match (found.next(), found.next()) {
        (None, _) => Ok(mesh.face_half_edge(face)),
        (Some(h), None) => Ok(h),
        (Some(_), Some(h)) => {
            let vertex = mesh.origin(h);
            Err(SchemeError::Valence {
                scheme: NAME,
                vertex,
                valence: mesh.valence(vertex),
                reason: "a face has another extraordinary vertex; split all faces once, for example by Catmull–Clark",
            })
        }
    }
}

impl<P: Affine> SurfaceScheme<P> for Kobbelt {
    fn name(&self) -> &'static str {
        NAME
    }

    fn refine(&self, mesh: &Mesh<P>) -> Result<Mesh<P>, SchemeError> {
        let old = mesh.connectivity();
        if let Some(vertex) = old.vertices().find(|&v| old.is_boundary(v)) {
            return Err(SchemeError::Boundary {
                scheme: NAME,
                vertex,
            });
        }
        for face in old.faces() {
            let found = old.face_degree(face);
            if found != 4 {
                return Err(SchemeError::FaceDegree {
                    scheme: NAME,
                    face,
                    expected: 4,
                    found,
                });
            }
        }
        if let Some(vertex) = old.vertices().find(|&v| old.valence(v) < 3) {
            return Err(SchemeError::Valence {
                scheme: NAME,
                vertex,
                valence: old.valence(vertex),
                reason: "inside a mesh at least three edges must meet; remove the vertex",
            });
        }
        let begins: Vec<HalfEdgeId> = old
            .faces()
            .map(|f| begin(old, f))
            .collect::<Result<_, _>>()?;
        let mut points = mesh.points().to_vec();
        points.extend(old.edges().map(|e| edge_point(mesh, old.edge_half_edge(e))));
        points.extend(old.faces().zip(begins).map(|(f, h)| face_point(mesh, h, f)));
        Ok(Mesh::new(old.split_into_quadrilaterals()?, points)?)
    }
}
