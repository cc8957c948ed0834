//! Wrong ideas of Loop's scheme.

use cagd::affine::{Affine, Point, Vector};
use cagd::scalar::OrderedScalar;
use cagd::subdivision::laws::Refined;
use cagd::subdivision::{
    CosineOfTurn, LatticeMask, Loop, Mesh, SchemeError, SurfaceScheme, VertexId, box_spline_222,
    loop_lattice_mask,
};

/// Leaves old vertices where they are and puts new ones into the middles of edges.
pub fn linear_mask<T: CosineOfTurn>() -> LatticeMask<T> {
    LatticeMask::three_direction([1, 1, 1]).shifted([-1, -1])
}

/// Swaps the weights of the ends of an edge and of the opposite vertices.
pub fn edge_weights_swapped<T: CosineOfTurn>() -> LatticeMask<T> {
    let mask = loop_lattice_mask::<T>().expect("valence 6");
    let (eighth, three) = (T::from_ratio(1, 8), T::from_ratio(3, 8));
    LatticeMask::new(mask.terms().map(|(index, weight)| {
        let swapped = match weight {
            w if *w == eighth => three.clone(),
            w if *w == three => eighth.clone(),
            w => w.clone(),
        };
        (index, swapped)
    }))
}

/// Has the diagonals run the other way.
pub fn other_diagonal<T: OrderedScalar>(x: &[T; 2]) -> T {
    box_spline_222(&[x[0].clone(), -x[1].clone()])
}

/// Starts at the origin instead of having its centre there.
pub fn not_centred<T: OrderedScalar>(x: &[T; 2]) -> T {
    let two = T::from_integer(2);
    box_spline_222(&[x[0].clone() - two.clone(), x[1].clone() - two])
}

/// The piecewise linear function with the right values at lattice points and twice the width.
pub fn hat<T: OrderedScalar>(x: &[T; 2]) -> T {
    let values = |i, j| box_spline_222(&[T::from_integer(i), T::from_integer(j)]);
    let height = |i: i64, j: i64| {
        let [u, v] = [
            x[0].clone() - T::from_integer(i),
            x[1].clone() - T::from_integer(j),
        ];
        let zero = T::zero();
        let largest = u.clone().max(v.clone()).max(zero.clone());
        let smallest = u.min(v).min(zero.clone());
        (T::one() - (largest - smallest)).max(zero)
    };
    (-1..=1)
        .flat_map(|i| (-1..=1).map(move |j| (i, j)))
        .fold(T::zero(), |sum, (i, j)| sum + values(i, j) * height(i, j))
}

/// Gives the neighbours of every vertex the weight 1/16, which is right for valence 6.
pub fn regular_weights_everywhere<T: CosineOfTurn>(
    mesh: &Mesh<Point<T, 3>>,
) -> Refined<Point<T, 3>> {
    let refined = Loop.refine(mesh)?;
    let old = mesh.connectivity();
    let mut points = refined.points().to_vec();
    for v in old.vertices().filter(|&v| !old.is_boundary(v)) {
        let k = old.valence(v) as i64;
        points[v.index()] = Point::new([0, 1, 2].map(|axis: usize| {
            let own = mesh.point(v)[axis].clone() * T::from_ratio(16 - k, 16);
            let neighbours = old.neighbours(v).map(|n| mesh.point(n)[axis].clone());
            neighbours.fold(own, |sum, x| sum + x * T::from_ratio(1, 16))
        }));
    }
    Ok(Mesh::new(refined.connectivity().clone(), points)?)
}

/// Puts the new vertices into the middles of the edges.
pub fn midpoints<T: CosineOfTurn>(mesh: &Mesh<Point<T, 3>>) -> Refined<Point<T, 3>> {
    let refined = Loop.refine(mesh)?;
    let old = mesh.connectivity();
    let mut points = refined.points().to_vec();
    for e in old.edges() {
        let [a, b] = old.edge_vertices(e).map(|v| mesh.point(v));
        points[old.vertex_count() + e.index()] = a.lerp(b, T::from_ratio(1, 2));
    }
    Ok(Mesh::new(refined.connectivity().clone(), points)?)
}

/// Takes the weights of the regular limit stencil, 6 and 1, at every valence.
pub fn regular_limit<T: CosineOfTurn>(
    mesh: &Mesh<Point<T, 3>>,
    v: VertexId,
) -> Result<Point<T, 3>, SchemeError> {
    let old = mesh.connectivity();
    if old.is_boundary(v) {
        return Loop.limit_point(mesh, v);
    }
    let k = old.valence(v) as i64;
    Ok(Point::new([0, 1, 2].map(|axis: usize| {
        let own = mesh.point(v)[axis].clone() * T::from_ratio(6, 6 + k);
        let neighbours = old.neighbours(v).map(|n| mesh.point(n)[axis].clone());
        neighbours.fold(own, |sum, x| sum + x * T::from_ratio(1, 6 + k))
    })))
}

/// Takes the vertex point of the next step for the limit.
pub fn one_step<T: CosineOfTurn>(
    mesh: &Mesh<Point<T, 3>>,
    v: VertexId,
) -> Result<Point<T, 3>, SchemeError> {
    Ok(Loop.refine(mesh)?.point(v).clone())
}

/// Takes two edges for the tangents.
pub fn edges_as_tangents<T: CosineOfTurn>(
    mesh: &Mesh<Point<T, 3>>,
    v: VertexId,
) -> Result<[Vector<T, 3>; 2], SchemeError> {
    let mut ring = mesh.connectivity().neighbours(v);
    let mut edge = || match ring.next() {
        Some(n) => mesh.point(n).clone() - mesh.point(v).clone(),
        None => Vector::zeros(),
    };
    Ok([edge(), edge()])
}
