use cagd::affine::Point;
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::{Creases, Loop, Mesh, VertexId, loop_beta, solids};
use proptest::prelude::*;

type Place = Point<BigRational, 3>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn place(coordinates: [i64; 3]) -> Place {
    Point::new(coordinates.map(|n| fraction(n, 1)))
}

/// Six neighbours, of which those with these numbers are at sharp edges.
fn six(sharp: &[usize]) -> Vec<(Place, bool)> {
    let ring = [
        [16, 0, 0],
        [16, 16, 0],
        [0, 16, 16],
        [-32, 0, 0],
        [-16, -16, 0],
        [0, -16, 32],
    ];
    let tagged = |(i, p)| (place(p), sharp.contains(&i));
    ring.into_iter().enumerate().map(tagged).collect()
}

fn at_six(sharp: &[usize]) -> Place {
    answer::vertex_point(&place([0, 0, 32]), &six(sharp), &fraction(1, 16))
}

fn probes() -> Vec<String> {
    cagd::probes![
        at_six(&[]),
        at_six(&[1]),
        at_six(&[0, 3]),
        at_six(&[0, 1]),
        at_six(&[0, 2, 4])
    ]
}

fn compare(sharp: &[usize], expected: Place) {
    let ring: Vec<String> = six(&[]).iter().map(|(p, _)| p.to_string()).collect();
    claim("the vertex point")
        .input(format!(
            "v = (0, 0, 32), β = 1/16, neighbours {}; the edges to neighbours {sharp:?} are sharp",
            ring.join(", ")
        ))
        .equal(at_six(sharp), expected);
}

/// Why: without tags it is the rule of the scheme.
#[test]
fn smooth() {
    compare(&[], place([-1, 0, 23]));
}

/// Why: an edge that ends at the vertex is a dart; it does not hold the vertex.
#[test]
fn a_dart() {
    compare(&[1], place([-1, 0, 23]));
}

/// Why: the crease, straight on or with a bend.
#[test]
fn a_crease() {
    compare(&[0, 3], place([-2, 0, 24]));
    compare(&[0, 1], place([4, 2, 24]));
}

/// Why: where more creases meet, nothing moves.
#[test]
fn a_corner() {
    compare(&[0, 2, 4], place([0, 0, 32]));
    compare(&[0, 1, 2, 3, 4, 5], place([0, 0, 32]));
}

/// Why: a crease must not depend on what lies beside it, or two meshes with the same crease would gape.
#[test]
fn the_crease_alone_counts() {
    let ring = |side: [i64; 3]| {
        [
            ([8, 0, 0], true),
            (side, false),
            ([0, 8, 0], true),
            ([1, 1, 1], false),
        ]
        .map(|(p, sharp)| (place(p), sharp))
    };
    let v = place([0, 0, 8]);
    let [one, other] = [[0, 0, 0], [80, 80, 80]]
        .map(|side| answer::vertex_point(&v, &ring(side), &fraction(31, 256)));
    claim("the vertex point on a crease")
        .input("the edges to neighbours 0 and 2 of four are sharp; neighbour 1 is moved from (0, 0, 0) to (80, 80, 80)")
        .equal(other, one);
}

proptest! {
    /// Why: it compares with the library, for the tags of any edges of a fan.
    #[test]
    fn as_the_scheme(
        k in prop::sample::select(vec![3_usize, 4, 6]),
        coordinates in prop::collection::vec(any::<[i8; 3]>(), 7),
        tags in any::<[bool; 6]>(),
    ) {
        let points: Vec<Place> = coordinates
            .into_iter()
            .take(k + 1)
            .map(|p| place(p.map(i64::from)))
            .collect();
        let mesh = Mesh::new(solids::triangle_fan(k), points.clone()).expect("one point a vertex");
        let fan = mesh.connectivity();
        let sharp = fan
            .vertex_ring(VertexId(0))
            .filter(|&h| tags[fan.destination(h).index() - 1])
            .map(|h| fan.edge(h));
        let creases = Creases::new(fan, sharp, []).expect("edges of the fan");
        let (refined, _) = Loop.refine_creased(&mesh, &creases).expect("a mesh of triangles");
        let ring: Vec<(Place, bool)> = points[1..].iter().cloned().zip(tags).collect();
        let beta = loop_beta::<BigRational>(k).expect("rational for these valences");
        claim("the vertex point").equal(
            answer::vertex_point(&points[0], &ring, &beta),
            refined.point(VertexId(0)).clone(),
        );
    }
}
