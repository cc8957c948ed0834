//! Mistakes with Kobbelt's scheme.

use cagd::affine::Affine;
use cagd::scalar::Scalar;
use cagd::subdivision::laws::Refined;
use cagd::subdivision::{CatmullClark, Kobbelt, Mesh, SurfaceScheme, kobbelt_virtual_weights};
use num_traits::Zero;

fn combined<P: Affine>(weights: &[Vec<P::Scalar>; 2], points: [&[P]; 2]) -> P {
    P::from_fn(|axis| {
        let terms = weights
            .iter()
            .zip(points)
            .flat_map(|(w, p)| w.iter().zip(p));
        terms.fold(P::Scalar::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point.coordinates()[axis].clone()
        })
    })
}

/// Takes the factor 1/5 of w/(4 + w) with w = 1 for 1/9.
pub fn one_fifth<P: Affine>(neighbours: &[P], opposite: &[P]) -> P {
    let [near, far] = kobbelt_virtual_weights::<P::Scalar>(neighbours.len());
    let factor = P::Scalar::from_ratio(9, 5);
    let far = far.into_iter().map(|w| w * factor.clone()).collect();
    combined(&[near, far], [neighbours, opposite])
}

/// Takes the neighbour opposite by its number.
pub fn opposite_by_number<P: Affine>(neighbours: &[P], _: &[P]) -> P {
    neighbours[neighbours.len() / 2].clone()
}

/// Reflects the neighbour at the mean of all neighbours.
pub fn reflected<P: Affine>(neighbours: &[P], _: &[P]) -> P {
    let share = P::Scalar::from_ratio(2, neighbours.len() as i64);
    let mut weights = vec![share; neighbours.len()];
    weights[0] = weights[0].clone() - P::Scalar::from_integer(1);
    combined(&[weights, vec![]], [neighbours, &[]])
}

/// Begins the opposite points with the face before the edge.
pub fn opposite_one_early<P: Affine>(neighbours: &[P], opposite: &[P]) -> P {
    let mut opposite = opposite.to_vec();
    opposite.rotate_left(1);
    cagd::subdivision::kobbelt_virtual_point(neighbours, &opposite)
}

/// Takes the midpoint for the edge point.
pub fn midpoints<P: Affine>(mesh: &Mesh<P>) -> Refined<P> {
    let refined = Kobbelt.refine(mesh)?;
    let old = mesh.connectivity();
    let mut points = refined.points().to_vec();
    for e in old.edges() {
        let [a, b] = old.edge_vertices(e).map(|v| mesh.point(v));
        points[old.vertex_count() + e.index()] = a.lerp(b, P::Scalar::from_ratio(1, 2));
    }
    Ok(Mesh::new(refined.connectivity().clone(), points)?)
}

/// Moves the old vertices, as approximating schemes do.
pub fn approximating<P: Affine>(mesh: &Mesh<P>) -> Refined<P> {
    CatmullClark.refine(mesh)
}
