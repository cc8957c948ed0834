//! Mistakes with Catmull–Clark subdivision, its limits and creases.

use cagd::affine::Affine;
use cagd::scalar::Scalar;
use cagd::subdivision::laws::Refined;
use cagd::subdivision::{CatmullClark, Creases, Mesh, SchemeError, SurfaceScheme, VertexId};

/// The refined mesh of the library with some points replaced; `point` gets the numbers of the vertex and of V and E.
fn replaced<P: Affine>(
    mesh: &Mesh<P>,
    point: impl Fn(&Mesh<P>, &Mesh<P>, usize, [usize; 2]) -> Option<P>,
) -> Refined<P> {
    let refined = CatmullClark.refine(mesh)?;
    let old = mesh.connectivity();
    let counts = [old.vertex_count(), old.edge_count()];
    let points = refined.points().iter().enumerate();
    let points = points
        .map(|(i, p)| point(mesh, &refined, i, counts).unwrap_or_else(|| p.clone()))
        .collect();
    Ok(Mesh::new(refined.connectivity().clone(), points)?)
}

/// Takes the midpoint of every edge for its edge point.
pub fn midpoints_for_edge_points<P: Affine>(mesh: &Mesh<P>) -> Refined<P> {
    replaced(mesh, |mesh, _, i, [v, e]| {
        let edge = mesh.connectivity().edges().nth(i.checked_sub(v)?)?;
        let [a, b] = mesh.connectivity().edge_vertices(edge);
        (i < v + e).then(|| {
            mesh.point(a)
                .lerp(mesh.point(b), P::Scalar::from_ratio(1, 2))
        })
    })
}

/// Leaves the old vertices where they are.
pub fn vertices_stay<P: Affine>(mesh: &Mesh<P>) -> Refined<P> {
    replaced(mesh, |mesh, _, i, [v, _]| {
        (i < v).then(|| mesh.points()[i].clone())
    })
}

/// Takes (F + 2R + v)/4 at every vertex, the rule of valence 4.
pub fn valence_four_everywhere<P: Affine>(mesh: &Mesh<P>) -> Refined<P> {
    replaced(mesh, |mesh, refined, i, [v, e]| {
        let old = mesh.connectivity();
        let vertex = VertexId(i as u32);
        if i >= v || old.is_boundary(vertex) {
            return None;
        }
        let ring: Vec<_> = old.vertex_ring(vertex).collect();
        let share = P::Scalar::from_ratio(1, ring.len() as i64);
        let quarter = P::Scalar::from_ratio(1, 4);
        Some(P::from_fn(|axis| {
            let own = mesh.points()[i].coordinates()[axis].clone();
            ring.iter().fold(own.clone() * quarter.clone(), |sum, &h| {
                let face = old.face(h).map_or(0, cagd::subdivision::FaceId::index);
                let around = refined.points()[v + e + face].coordinates()[axis].clone()
                    + own.clone()
                    + mesh.point(old.destination(h)).coordinates()[axis].clone();
                sum + around * share.clone() * quarter.clone()
            })
        }))
    })
}

/// Takes the average of Doo and Sabin's kind: (F + v)/2 at every vertex.
pub fn edges_forgotten<P: Affine>(mesh: &Mesh<P>) -> Refined<P> {
    replaced(mesh, |mesh, refined, i, [v, e]| {
        let old = mesh.connectivity();
        if i >= v {
            return None;
        }
        let faces: Vec<_> = old
            .vertex_ring(VertexId(i as u32))
            .filter_map(|h| old.face(h))
            .collect();
        let share = P::Scalar::from_ratio(1, 2 * faces.len() as i64);
        Some(P::from_fn(|axis| {
            let own = mesh.points()[i].coordinates()[axis].clone();
            let own = own * P::Scalar::from_ratio(1, 2);
            faces.iter().fold(own, |sum, f| {
                sum + refined.points()[v + e + f.index()].coordinates()[axis].clone()
                    * share.clone()
            })
        }))
    })
}

/// Takes the vertex itself for its limit.
pub fn limit_is_the_vertex<P: Affine>(mesh: &Mesh<P>, v: VertexId) -> Result<P, SchemeError> {
    CatmullClark.star(mesh, v)?;
    Ok(mesh.point(v).clone())
}

/// Takes the point after one step for the limit.
pub fn limit_after_one_step<P: Affine>(mesh: &Mesh<P>, v: VertexId) -> Result<P, SchemeError> {
    Ok(CatmullClark.refine(mesh)?.point(v).clone())
}

/// Takes the weights 16, 4, 1 of valence 4 at every vertex.
pub fn limit_of_valence_four<P: Affine>(mesh: &Mesh<P>, v: VertexId) -> Result<P, SchemeError> {
    let star = CatmullClark.star(mesh, v)?;
    let k = star.neighbours.len() as i64;
    let share = |n| P::Scalar::from_ratio(n, 16 + 5 * k);
    Ok(P::from_fn(|axis| {
        let at = |v: VertexId| mesh.point(v).coordinates()[axis].clone();
        let own = at(v) * share(16);
        let near = star
            .neighbours
            .iter()
            .fold(own, |sum, &e| sum + at(e) * share(4));
        star.opposite
            .iter()
            .fold(near, |sum, &f| sum + at(f) * share(1))
    }))
}

/// Takes the differences of the points after a step for the tangents at valence 4.
pub fn tangents_without_opposite<P: Affine>(
    mesh: &Mesh<P>,
    v: VertexId,
) -> Result<[P::Difference; 2], SchemeError> {
    let star = CatmullClark.star(mesh, v)?;
    let at = |j: usize| mesh.point(star.neighbours[j % star.neighbours.len()]);
    Ok([at(0).difference(at(2)), at(1).difference(mesh.point(v))])
}

type Creased<P> = Result<(Mesh<P>, Creases), SchemeError>;

/// Ignores the tags: only the boundary is sharp.
pub fn tags_ignored<P: Affine>(mesh: &Mesh<P>, creases: &Creases) -> Creased<P> {
    let (refined, _) = CatmullClark.refine_creased(mesh, &Creases::none(mesh.connectivity()))?;
    let (_, finer) = CatmullClark.refine_creased(mesh, creases)?;
    Ok((refined, finer))
}

/// Forgets the tags after one step.
pub fn tags_lost<P: Affine>(mesh: &Mesh<P>, creases: &Creases) -> Creased<P> {
    let (refined, _) = CatmullClark.refine_creased(mesh, creases)?;
    let none = Creases::none(refined.connectivity());
    Ok((refined, none))
}

/// Keeps every vertex of a crease where it is.
pub fn crease_vertices_stay<P: Affine>(mesh: &Mesh<P>, creases: &Creases) -> Creased<P> {
    let old = mesh.connectivity();
    let on_crease = |v: &VertexId| {
        let mut around = old.vertex_ring(*v);
        around.any(|h| creases.is_sharp(old, old.edge(h)))
    };
    let sharp = old.edges().filter(|&e| creases.is_sharp(old, e));
    let all = Creases::new(old, sharp, old.vertices().filter(on_crease));
    let all = all.expect("they are elements of the mesh");
    let (refined, _) = CatmullClark.refine_creased(mesh, &all)?;
    let (_, finer) = CatmullClark.refine_creased(mesh, creases)?;
    Ok((refined, finer))
}
