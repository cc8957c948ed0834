use cagd::affine::Point;
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::{CatmullClark, Mesh, SurfaceScheme, VertexId, solids};
use proptest::prelude::*;

type Place = Point<BigRational, 3>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn place(coordinates: [i64; 3]) -> Place {
    Point::new(coordinates.map(|n| fraction(n, 1)))
}

/// `k` quadrilaterals around vertex 0; its neighbours have odd numbers, the opposite vertices even ones.
fn fan(k: usize, points: impl IntoIterator<Item = Place>) -> Mesh<Place> {
    let points = points.into_iter().take(2 * k + 1).collect();
    Mesh::new(solids::quadrilateral_fan(k), points).expect("one point a vertex")
}

/// A fan in which only one vertex is not 0.
fn raised(k: usize, vertex: usize, height: i64) -> Mesh<Place> {
    fan(
        k,
        (0..=2 * k).map(|i| place([0, 0, if i == vertex { height } else { 0 }])),
    )
}

fn probes() -> Vec<String> {
    let height =
        |k: usize, vertex: usize| answer::limit_position(&raised(k, vertex, 3600), VertexId(0));
    cagd::probes![
        height(3, 0),
        height(3, 1),
        height(3, 2),
        height(4, 0),
        height(4, 1),
        height(4, 2),
        height(5, 0),
        height(5, 1),
    ]
}

/// Why: the weights of the grid are products of those of the cubic curve, and easy to remember.
#[test]
fn on_a_grid() {
    for (vertex, expected) in [(0, 16), (3, 4), (4, 1)] {
        claim("the limit of vertex 0")
            .input(format!(
                "four squares around vertex 0, neighbours 1, 3, 5, 7 and opposite vertices 2, 4, 6, 8; \
                 vertex {vertex} is (0, 0, 36), all others are 0"
            ))
            .equal(
                answer::limit_position(&raised(4, vertex, 36), VertexId(0)),
                place([0, 0, expected]),
            );
    }
}

/// Why: the cube has valence 3 everywhere; its vertices end half-way to the centre.
#[test]
fn a_cube() {
    let cube = solids::cube::<BigRational>();
    let vertex = cube.point(VertexId(0));
    let expected = Point::new([0, 1, 2].map(|axis: usize| vertex[axis].clone() * fraction(1, 2)));
    claim("the limit of vertex 0 of the cube")
        .input(format!("vertex 0 is {vertex}, and the centre is (0, 0, 0)"))
        .equal(answer::limit_position(&cube, VertexId(0)), expected);
}

/// Why: the sum of the weights by itself.
#[test]
fn equal_points() {
    let p = place([3, -1, 4]);
    for k in 3..8 {
        let mesh = fan(k, std::iter::repeat_n(p.clone(), 2 * k + 1));
        claim("the limit of vertex 0")
            .input(format!("{k} quadrilaterals around it, all vertices at {p}"))
            .equal(answer::limit_position(&mesh, VertexId(0)), p.clone());
    }
}

/// Why: it needs no formula at all.
#[test]
fn after_a_step_the_same() {
    let mesh = solids::plate_with_holes::<BigRational>(1);
    let once = CatmullClark.refine(&mesh).expect("it can be refined");
    let twice = CatmullClark.refine(&once).expect("it can be refined");
    for v in mesh.connectivity().vertices() {
        let valence = mesh.connectivity().valence(v);
        claim("the limit before and after a step")
            .input(format!(
                "{v} of a refined plate with a hole, valence {valence}"
            ))
            .equal(
                answer::limit_position(&once, v),
                answer::limit_position(&twice, v),
            );
    }
}

proptest! {
    /// Why: any valence, any points.
    #[test]
    fn around_any_vertex(k in 3_usize..8, coordinates in prop::collection::vec(any::<[i8; 3]>(), 15)) {
        let mesh = fan(k, coordinates.into_iter().map(|p| place(p.map(i64::from))));
        let sides = k as i64;
        let expected = Point::new([0, 1, 2].map(|axis: usize| {
            let sum = (0..=2 * k).fold(fraction(0, 1), |sum, i| {
                let weight = match i {
                    0 => sides * sides,
                    i if i % 2 == 1 => 4,
                    _ => 1,
                };
                sum + mesh.points()[i][axis].clone() * fraction(weight, 1)
            });
            sum / fraction(sides * (sides + 5), 1)
        }));
        claim("the limit of vertex 0").equal(answer::limit_position(&mesh, VertexId(0)), expected);
    }
}
