//! Loop's scheme over rationals.

use cagd::affine::{Point, Vector};
use cagd::scalar::BigRational;
use cagd::subdivision::{
    Butterfly, FanNet, HalfEdgeMesh, LatticeMask, Loop, Mesh, SchemeError, SubdivisionMatrix,
    SurfaceScheme, VertexId, box_spline_222, laws, loop_lattice_mask, solids,
};

use crate::inputs::{for_each, integer, ratio};
use crate::support::mutants::subdivision::loop_scheme as mutants;
use crate::support::{holds, rejects};

/// M(x) and the M(2x − j) are polynomials of degree 4 on the triangles of the half lattice, and a triangle with side 1/2
/// has 15 points with denominator 8 in it, which determine such a polynomial.
/// All of them in one square with side 4 that contains the support prove the refinement equation.
#[test]
fn loop_box_spline() {
    type Spline = fn(&[BigRational; 2]) -> BigRational;
    // M(−x) = M(x), so half of the square is enough.
    let places = (-16..=16).flat_map(|i| (0..=16).map(move |j| [ratio(i, 8), ratio(j, 8)]));
    let places: Vec<_> = places.collect();
    let law = |mask: LatticeMask<BigRational>, spline: Spline| {
        for_each(places.clone(), |x| laws::loop_box_spline(&mask, spline, x))
    };
    let mask = || loop_lattice_mask().expect("valence 6");
    holds(law(mask(), box_spline_222));
    rejects("linear", law(mutants::linear_mask(), box_spline_222));
    rejects(
        "edge weights swapped",
        law(mutants::edge_weights_swapped(), box_spline_222),
    );
    rejects("other diagonal", law(mask(), mutants::other_diagonal));
    rejects("not centred", law(mask(), mutants::not_centred));
    rejects("piecewise linear", law(mask(), mutants::hat));
}

type Place = Point<BigRational, 3>;

/// Closed meshes with valences 3, 4 and 6, and fans, which have a boundary; with unit points the laws are proved for these meshes.
pub fn meshes() -> Vec<Mesh<Place>> {
    let mut connectivities = vec![
        solids::tetrahedron::<f64>().connectivity().clone(),
        solids::octahedron::<f64>().connectivity().clone(),
        solids::torus_triangles(3, 3),
    ];
    connectivities.extend([3, 4, 6].map(solids::triangle_fan));
    connectivities.into_iter().flat_map(unit_points).collect()
}

/// The meshes with these faces in which one point is raised.
pub fn unit_points(mesh: HalfEdgeMesh) -> impl Iterator<Item = Mesh<Place>> {
    (0..mesh.vertex_count()).map(move |one| {
        let point =
            |v: usize| Point::new([integer(i64::from(v == one)), integer(v as i64), integer(1)]);
        Mesh::new(mesh.clone(), (0..mesh.vertex_count()).map(point).collect())
            .expect("finite points")
    })
}

#[test]
fn loop_rules() {
    let law = |implementation: fn(&Mesh<Place>) -> laws::Refined<Place>| {
        for_each(meshes(), |mesh| laws::loop_rules(implementation, mesh))
    };
    holds(law(|mesh| Loop.refine(mesh)));
    rejects("1/16 everywhere", law(mutants::regular_weights_everywhere));
    rejects("midpoints", law(mutants::midpoints));
}

#[test]
fn loop_properties() {
    let law = |scheme: &dyn Fn(usize) -> SubdivisionMatrix<BigRational>| {
        for_each([3, 4, 6], |&valence| {
            laws::loop_properties(&scheme(valence))
        })
    };
    let matrix = |valence| {
        SubdivisionMatrix::extract(&Loop, FanNet::Triangles, valence, 1)
            .expect("a rational valence")
    };
    holds(law(&matrix));
    let butterfly = |valence| {
        let two = SubdivisionMatrix::extract(&Butterfly::MODIFIED, FanNet::Triangles, valence, 2);
        two.expect("a rational valence")
    };
    rejects("the Butterfly scheme", law(&butterfly));
}

#[test]
fn loop_limit() {
    type Limit = fn(&Mesh<Place>, VertexId) -> Result<Place, SchemeError>;
    type Tangents = fn(&Mesh<Place>, VertexId) -> Result<[Vector<BigRational, 3>; 2], SchemeError>;
    let law = |limit: Limit, tangents: Tangents| {
        for_each(meshes(), |mesh| {
            laws::loop_limit(|mesh| Loop.refine(mesh), limit, tangents, mesh)
        })
    };
    let (limit, tangents): (Limit, Tangents) = (
        |mesh, v| Loop.limit_point(mesh, v),
        |mesh, v| Loop.limit_tangents(mesh, v),
    );
    holds(law(limit, tangents));
    rejects("6 and 1 everywhere", law(mutants::regular_limit, tangents));
    rejects("one step", law(mutants::one_step, tangents));
    rejects("edges", law(limit, mutants::edges_as_tangents));
}

/// On a regular torus the refined spike has the limits M(x) at the points of the finer lattices.
#[test]
fn a_spike_becomes_the_box_spline() {
    let n = 8;
    let torus = solids::torus_triangles(n, n);
    let heights = (0..n * n).map(|v| integer(i64::from(v == 4 * n + 4)));
    let spike = Mesh::new(torus, heights.collect()).expect("finite heights");
    let refined = Loop.refine(&spike).expect("valence 6");
    let old = spike.connectivity();
    let place = |v: u32| [v as i64 % n as i64, v as i64 / n as i64];
    for e in old.edges() {
        let ends = old.edge_vertices(e).map(|v| place(v.0));
        // Edges across the border of the square have no middle in it.
        if (0..2).any(|k| (ends[0][k] - ends[1][k]).abs() > 1) {
            continue;
        }
        let middle = [0, 1].map(|k: usize| ratio(ends[0][k] + ends[1][k] - 8, 2));
        let vertex = VertexId((old.vertex_count() + e.index()) as u32);
        let limit: BigRational = Loop.limit_point(&refined, vertex).expect("valence 6");
        assert_eq!(limit, box_spline_222(&middle), "at {middle:?}");
    }
}
