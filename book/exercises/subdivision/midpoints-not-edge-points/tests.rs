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

/// The mean of some points.
fn mean(points: &[Place]) -> Place {
    Point::new([0, 1, 2].map(|axis: usize| {
        let sum = points
            .iter()
            .fold(fraction(0, 1), |sum, p| sum + p[axis].clone());
        sum / fraction(points.len() as i64, 1)
    }))
}

/// The face points of quadrilaterals around `v`; `opposite[j]` is the fourth vertex between the neighbours j and j + 1.
fn face_points(v: &Place, neighbours: &[Place], opposite: &[Place]) -> Vec<Place> {
    let k = neighbours.len();
    let face = |j: usize| {
        let corners = [v, &neighbours[j], &opposite[j], &neighbours[(j + 1) % k]];
        mean(&corners.map(Clone::clone))
    };
    (0..k).map(face).collect()
}

fn found(v: &Place, neighbours: &[Place], opposite: &[Place]) -> Place {
    answer::vertex_point(v, neighbours, &face_points(v, neighbours, opposite))
}

fn probes() -> Vec<String> {
    let corner = place([8, 0, 0]);
    let ring = [[0, 8, 0], [0, 0, 8], [1, 1, 1], [5, 0, 3]].map(place);
    let opposite = [[0, 0, 0], [7, 0, 1], [2, 2, 8], [0, 16, 0]].map(place);
    cagd::probes![
        found(&corner, &ring[..3], &opposite[..3]),
        found(&corner, &ring, &opposite),
    ]
}

/// Why: each weight by itself: only one of the points around a vertex of valence 4 is not 0.
#[test]
fn weights_on_a_grid() {
    let zero = || vec![place([0, 0, 0]); 4];
    let one = place([64, 0, 0]);
    let mut ring = zero();
    ring[1] = one.clone();
    for (name, v, neighbours, opposite, weight) in [
        ("v = (64, 0, 0)", one.clone(), zero(), zero(), 36),
        ("e₁ = (64, 0, 0)", place([0, 0, 0]), ring.clone(), zero(), 6),
        (
            "the fourth vertex of face 1 = (64, 0, 0)",
            place([0, 0, 0]),
            zero(),
            ring,
            1,
        ),
    ] {
        claim("the rule for valence 4")
            .input(format!("{name}, all other points 0"))
            .equal(found(&v, &neighbours, &opposite), place([weight, 0, 0]));
    }
}

/// Why: the cube is the example of every book: its vertices move to 5/9 of their distance from the centre.
#[test]
fn a_cube() {
    let ring = [[-9, 9, 9], [9, -9, 9], [9, 9, -9]].map(place);
    let opposite = [[-9, -9, 9], [9, -9, -9], [-9, 9, -9]].map(place);
    claim("a vertex of the cube")
        .input("v = (9, 9, 9), all vertices (±9, ±9, ±9)")
        .equal(found(&place([9, 9, 9]), &ring, &opposite), place([5, 5, 5]));
}

/// Why: it tests what the rule does with the numbers of any valence.
#[test]
fn constant() {
    let p = place([3, -1, 4]);
    for k in 3..8 {
        let all = vec![p.clone(); k];
        claim("equal points")
            .input(format!("{k} neighbours, all points {p}"))
            .equal(found(&p, &all, &all), p.clone());
    }
}

proptest! {
    /// Why: it compares with the whole scheme, for valences from 3 on.
    #[test]
    fn as_the_scheme(
        k in 3_usize..7,
        coordinates in prop::collection::vec(any::<[i8; 3]>(), 13),
    ) {
        let connectivity = solids::quadrilateral_fan(k);
        let points: Vec<Place> = coordinates
            .into_iter()
            .take(2 * k + 1)
            .map(|p| place(p.map(i64::from)))
            .collect();
        let at = |first: usize| points.iter().skip(first).step_by(2).take(k).cloned().collect::<Vec<_>>();
        let found = found(&points[0], &at(1), &at(2));
        let mesh = Mesh::new(connectivity, points).expect("one point a vertex");
        let refined = CatmullClark.refine(&mesh).expect("a mesh of quadrilaterals");
        claim("the vertex point").equal(found, refined.point(VertexId(0)).clone());
    }
}
