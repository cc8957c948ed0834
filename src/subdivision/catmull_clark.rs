//! Catmull–Clark subdivision: bicubic where the mesh is regular, defined for meshes of any polygons.

use super::creases::{Creases, VertexRule};
use super::stencil::{along_crease, count, mean, weighted};
use super::{EdgeId, FaceId, HalfEdgeId, Mesh, SchemeError, SurfaceScheme, VertexId};
use crate::affine::Affine;
use num_traits::One;

use crate::scalar::{Real, Scalar};

const NAME: &str = "Catmull–Clark";

/// The scheme of Catmull and Clark.
///
/// Face points are means of faces; the edge point of an inner edge is the mean of its ends and of the face points
/// beside it; a vertex of valence k goes to (F + 2R + (k − 3)v)/k, with the mean F of the face points around it and the
/// mean R of the midpoints of its edges. Boundaries and creases have the cubic rules for curves.
///
/// # Examples
///
/// ```
/// use cagd::affine::Point;
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::{CatmullClark, SurfaceScheme, VertexId, solids};
///
/// let cube = solids::cube::<BigRational>();
/// let refined = CatmullClark.refine(&cube)?;
/// let mesh = refined.connectivity();
/// assert_eq!([mesh.vertex_count(), mesh.edge_count(), mesh.face_count()], [26, 48, 24]);
///
/// // Each vertex of the cube keeps 5/9 of its distance from the centre.
/// let old = cube.point(VertexId(0)).from_origin();
/// let new = refined.point(VertexId(0)).from_origin();
/// assert_eq!(new, old * BigRational::from_ratio(5, 9));
/// # Ok::<(), cagd::subdivision::SchemeError>(())
/// ```
///
/// Source: `catmull-clark1978`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CatmullClark;

/// The weights of a vertex, of each neighbour and of each opposite vertex of its quadrilaterals in its vertex point:
/// 1 − 7/(4k), 3/(2k²), 1/(4k²).
///
/// # Examples
///
/// ```
/// use cagd::subdivision::catmull_clark_vertex_weights;
/// assert_eq!(catmull_clark_vertex_weights::<f64>(4), [9.0 / 16.0, 3.0 / 32.0, 1.0 / 64.0]);
/// ```
///
/// # Arguments
///
/// `valence`: the number k ≥ 1 of edges at the vertex; the rule is used for k ≥ 3.
#[must_use]
pub fn catmull_clark_vertex_weights<T: Scalar>(valence: usize) -> [T; 3] {
    let k = count::<T>(valence);
    let square = k.clone() * k.clone();
    [
        T::one() - T::from_ratio(7, 4) / k,
        T::from_ratio(3, 2) / square.clone(),
        T::from_ratio(1, 4) / square,
    ]
}

/// The weights of a vertex, of each neighbour and of each opposite vertex in the limit position:
/// k/(k + 5), 4/(k(k + 5)), 1/(k(k + 5)).
///
/// # Examples
///
/// ```
/// use cagd::subdivision::catmull_clark_limit_weights;
/// assert_eq!(catmull_clark_limit_weights::<f64>(4), [16.0 / 36.0, 4.0 / 36.0, 1.0 / 36.0]);
/// ```
///
/// # Arguments
///
/// `valence`: the number k ≥ 1 of edges at the vertex; the rule is used for k ≥ 3.
#[must_use]
pub fn catmull_clark_limit_weights<T: Scalar>(valence: usize) -> [T; 3] {
    let k = count::<T>(valence);
    let whole = k.clone() * (k.clone() + T::from_integer(5));
    [
        k.clone() * k / whole.clone(),
        T::from_integer(4) / whole.clone(),
        T::one() / whole,
    ]
}

/// The factor A = 1 + c + cos(π/k)·√(2(9 + c)), c = cos(2π/k), of the neighbours in the tangents.
///
/// The subdominant eigenvalue is λ = (A + 4)/16.
///
/// # Examples
///
/// ```
/// use cagd::subdivision::catmull_clark_tangent_factor;
/// assert!((catmull_clark_tangent_factor::<f64>(4) - 4.0).abs() < 1e-14, "so λ = 1/2");
/// ```
///
/// # Arguments
///
/// `valence`: the number k ≥ 3 of edges at the vertex.
#[must_use]
pub fn catmull_clark_tangent_factor<T: Real>(valence: usize) -> T {
    let half_turn = T::from_f64(std::f64::consts::PI) / count(valence);
    let c = (half_turn + half_turn).cos();
    let two = T::from_integer(2);
    T::one() + c + half_turn.cos() * (two * (T::from_integer(9) + c)).sqrt()
}

/// The points around an inner vertex: its neighbours and the opposite vertices of its quadrilaterals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct QuadrilateralStar {
    /// The neighbours e₀, …, counterclockwise.
    pub neighbours: Vec<VertexId>,
    /// The opposite vertex fⱼ of the face with the vertex, eⱼ and eⱼ₊₁.
    pub opposite: Vec<VertexId>,
}

impl CatmullClark {
    /// One step, with sharp edges and corners; also says what is sharp afterwards.
    ///
    /// # Errors
    ///
    /// [`SchemeError::Valence`] for a smooth vertex of valence 2, [`SchemeError::Mesh`] if the result is too large.
    pub fn refine_creased<P: Affine>(
        &self,
        mesh: &Mesh<P>,
        creases: &Creases,
    ) -> Result<(Mesh<P>, Creases), SchemeError> {
        let old = mesh.connectivity();
        let face_points: Vec<P> = old.faces().map(|f| face_point(mesh, f)).collect();
        let mut points =
            Vec::with_capacity(old.vertex_count() + old.edge_count() + old.face_count());
        for v in old.vertices() {
            points.push(vertex_point(mesh, creases, &face_points, v)?);
        }
        points.extend(
            old.edges()
                .map(|e| edge_point(mesh, creases, &face_points, e)),
        );
        points.extend(face_points);
        let refined = old.split_into_quadrilaterals()?;
        let creases = creases.refined(&refined);
        Ok((Mesh::new(refined, points)?, creases))
    }

    /// Where a vertex of a quadrilateral mesh ends after infinitely many steps.
    ///
    /// Inside: (k²v + 4Σeⱼ + Σfⱼ)/(k(k + 5)); on the boundary (a + 4v + b)/6.
    ///
    /// # Errors
    ///
    /// [`SchemeError::FaceDegree`] for an inner vertex with another face than a quadrilateral (refine once before),
    /// [`SchemeError::Valence`] for one of valence 2.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::affine::Point;
    /// use cagd::subdivision::{CatmullClark, VertexId, solids};
    ///
    /// let cube = solids::cube::<f64>();
    /// let corner = cube.point(VertexId(0)).from_origin();
    /// let limit = CatmullClark.limit_position(&cube, VertexId(0))?;
    /// assert!((limit.from_origin() - corner * 0.5).amax() < 1e-15);
    /// # Ok::<(), cagd::subdivision::SchemeError>(())
    /// ```
    pub fn limit_position<P: Affine>(&self, mesh: &Mesh<P>, v: VertexId) -> Result<P, SchemeError> {
        self.limit_position_creased(mesh, &Creases::UNTAGGED, v)
    }

    /// Where a vertex of a quadrilateral mesh ends after infinitely many steps of [`refine_creased`](Self::refine_creased).
    ///
    /// A corner stays, and a vertex of a crease goes to (a + 4v + b)/6 with its neighbours along it.
    /// What touches no sharp edge goes where it goes without tags: sharp edges farther away do not reach it.
    ///
    /// # Errors
    ///
    /// As [`limit_position`](Self::limit_position), and [`SchemeError::CreaseEnd`] where exactly one sharp edge ends.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::subdivision::{CatmullClark, Creases, SchemeError, VertexId, solids};
    ///
    /// let cube = solids::cube::<f64>();
    /// let mesh = cube.connectivity();
    /// let edge = mesh.edge(mesh.vertex_half_edge(VertexId(0)));
    /// let creases = Creases::new(mesh, [edge], [])?;
    /// let refused = CatmullClark.limit_position_creased(&cube, &creases, VertexId(0));
    /// assert!(matches!(refused, Err(SchemeError::CreaseEnd { .. })));
    ///
    /// let corner = Creases::new(mesh, [edge], [VertexId(0)])?;
    /// let limit = CatmullClark.limit_position_creased(&cube, &corner, VertexId(0))?;
    /// assert_eq!(&limit, cube.point(VertexId(0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn limit_position_creased<P: Affine>(
        &self,
        mesh: &Mesh<P>,
        creases: &Creases,
        v: VertexId,
    ) -> Result<P, SchemeError> {
        let old = mesh.connectivity();
        match creases.rule(old, v) {
            VertexRule::Corner => Ok(mesh.point(v).clone()),
            VertexRule::Crease(ends) => Ok(along_crease(mesh, v, ends, [4, 6])),
            VertexRule::Smooth if creases.is_dart(old, v) => Err(SchemeError::CreaseEnd {
                scheme: NAME,
                vertex: v,
            }),
            VertexRule::Smooth => {
                let star = self.star(mesh, v)?;
                let weights = catmull_clark_limit_weights(star.neighbours.len());
                Ok(weighted(mesh, star.with_weights(v, &weights)))
            }
        }
    }

    /// The tangents t₁ = Σ(A cⱼ eⱼ + (cⱼ + cⱼ₊₁)fⱼ) and t₂, the same with sines, at the limit of an inner vertex.
    ///
    /// Where they are linearly independent they span the tangent plane.
    ///
    /// # Errors
    ///
    /// As [`limit_position`](Self::limit_position), and [`SchemeError::Boundary`] on the boundary.
    pub fn limit_tangents<P: Affine>(
        &self,
        mesh: &Mesh<P>,
        v: VertexId,
    ) -> Result<[P::Difference; 2], SchemeError>
    where
        P::Scalar: Real,
    {
        if mesh.connectivity().is_boundary(v) {
            return Err(SchemeError::Boundary {
                scheme: NAME,
                vertex: v,
            });
        }
        let star = self.star(mesh, v)?;
        let k = star.neighbours.len();
        let factor = catmull_clark_tangent_factor::<P::Scalar>(k);
        let turn = P::Scalar::from_f64(std::f64::consts::TAU) / count(k);
        let base = mesh.point(v);
        let along = |wave: &dyn Fn(P::Scalar) -> P::Scalar| {
            let wave = |j: usize| wave(turn * count(j));
            let terms = (0..k).flat_map(|j| {
                [
                    (factor * wave(j), star.neighbours[j]),
                    (wave(j) + wave(j + 1), star.opposite[j]),
                ]
            });
            // The weights sum to 0, so the vector does not depend on the base point.
            let tip = weighted(mesh, terms.chain(std::iter::once((P::Scalar::one(), v))));
            tip.difference(base)
        };
        Ok([along(&|x| x.cos()), along(&|x| x.sin())])
    }

    /// The points around an inner vertex whose faces are quadrilaterals.
    ///
    /// # Errors
    ///
    /// [`SchemeError::Boundary`], [`SchemeError::FaceDegree`] or [`SchemeError::Valence`] if there is no such star.
    pub fn star<P: Affine>(
        &self,
        mesh: &Mesh<P>,
        v: VertexId,
    ) -> Result<QuadrilateralStar, SchemeError> {
        QuadrilateralStar::around(NAME, mesh, v)
    }
}

impl QuadrilateralStar {
    /// The star of a vertex, for a scheme of this name.
    pub(super) fn around<P: Affine>(
        scheme: &'static str,
        mesh: &Mesh<P>,
        v: VertexId,
    ) -> Result<Self, SchemeError> {
        let mesh = mesh.connectivity();
        let mut star = Self {
            neighbours: vec![],
            opposite: vec![],
        };
        for h in mesh.vertex_ring(v) {
            let Some(face) = mesh.face(h) else {
                return Err(SchemeError::Boundary { scheme, vertex: v });
            };
            let found = mesh.face_degree(face);
            if found != 4 {
                return Err(SchemeError::FaceDegree {
                    scheme,
                    face,
                    expected: 4,
                    found,
                });
            }
            star.neighbours.push(mesh.destination(h));
            star.opposite.push(mesh.destination(mesh.next(h)));
        }
        check_valence(scheme, v, star.neighbours.len())?;
        Ok(star)
    }

    /// The vertex, its neighbours and the opposite vertices with their three weights.
    fn with_weights<T: Scalar>(
        self,
        v: VertexId,
        [own, neighbour, opposite]: &[T; 3],
    ) -> impl Iterator<Item = (T, VertexId)> {
        let around = |weight: &T, vertices: Vec<VertexId>| {
            let weight = weight.clone();
            vertices.into_iter().map(move |v| (weight.clone(), v))
        };
        std::iter::once((own.clone(), v))
            .chain(around(neighbour, self.neighbours))
            .chain(around(opposite, self.opposite))
    }
}

impl<P: Affine> SurfaceScheme<P> for CatmullClark {
    fn name(&self) -> &'static str {
        NAME
    }

    fn refine(&self, mesh: &Mesh<P>) -> Result<Mesh<P>, SchemeError> {
        Ok(self.refine_creased(mesh, &Creases::UNTAGGED)?.0)
    }
}

fn check_valence(
    scheme: &'static str,
    vertex: VertexId,
    valence: usize,
) -> Result<(), SchemeError> {
    if valence < 3 {
        return Err(SchemeError::Valence {
            scheme,
            vertex,
            valence,
            reason: "inside a mesh at least three edges must meet; remove the vertex",
        });
    }
    Ok(())
}

fn face_point<P: Affine>(mesh: &Mesh<P>, f: FaceId) -> P {
    let corners: Vec<&P> = mesh.face_points(f).collect();
    mean(&corners)
}

fn edge_point<P: Affine>(mesh: &Mesh<P>, creases: &Creases, face_points: &[P], e: EdgeId) -> P {
    let old = mesh.connectivity();
    let [a, b] = old.edge_vertices(e).map(|v| mesh.point(v));
    let h = old.edge_half_edge(e);
    let beside = |h: HalfEdgeId| old.face(h).map(|f| &face_points[f.index()]);
    match (beside(h), beside(old.flip(h))) {
        (Some(left), Some(right)) if !creases.is_sharp(old, e) => mean(&[a, b, left, right]),
        _ => mean(&[a, b]),
    }
}

fn vertex_point<P: Affine>(
    mesh: &Mesh<P>,
    creases: &Creases,
    face_points: &[P],
    v: VertexId,
) -> Result<P, SchemeError> {
    let old = mesh.connectivity();
    match creases.rule(old, v) {
        VertexRule::Corner => Ok(mesh.point(v).clone()),
        VertexRule::Crease(ends) => Ok(along_crease(mesh, v, ends, [6, 8])),
        VertexRule::Smooth => {
            let ring: Vec<HalfEdgeId> = old.vertex_ring(v).collect();
            check_valence(NAME, v, ring.len())?;
            let faces = ring.iter().filter_map(|&h| old.face(h));
            let around: Vec<&P> = faces.map(|f| &face_points[f.index()]).collect();
            let ends: Vec<&P> = ring
                .iter()
                .map(|&h| mesh.point(old.destination(h)))
                .collect();
            // 2R = v + the mean of the neighbours.
            let (faces, ends) = (mean(&around), mean(&ends));
            let k = count::<P::Scalar>(ring.len());
            let own = (k.clone() - P::Scalar::from_integer(2)) / k.clone();
            let point = mesh.point(v);
            Ok(P::from_fn(|i| {
                let [f, e, v] = [&faces, &ends, point].map(|p| p.coordinates()[i].clone());
                (f + e) / k.clone() + own.clone() * v
            }))
        }
    }
}
