use cagd::affine::Point;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::{CosineOfTurn, doo_sabin_face};
use proptest::prelude::*;

type Place = Point<BigRational, 2>;

fn places(coordinates: &[[i64; 2]]) -> Vec<Place> {
    coordinates
        .iter()
        .map(|p| Point::new(p.map(|n| BigRational::from_ratio(n, 1))))
        .collect()
}

fn cosines<T: CosineOfTurn>(k: usize) -> Vec<T> {
    (0..k)
        .map(|j| T::cosine_of_turn(j as i64, k).expect("a number of this type"))
        .collect()
}

fn new_face(face: &[Place]) -> Vec<Place> {
    answer::new_face(face, &cosines(face.len()))
}

const TRAPEZIUM: [[i64; 2]; 4] = [[0, 0], [16, 0], [8, 8], [0, 8]];
const HEXAGON: [[i64; 2]; 6] = [[0, 0], [24, 0], [48, 24], [24, 48], [0, 48], [-24, 0]];

fn probes() -> Vec<String> {
    cagd::probes![
        new_face(&places(&[[0, 0], [12, 0], [0, 12]])),
        new_face(&places(&TRAPEZIUM)),
        new_face(&places(&HEXAGON)),
    ]
}

/// A polygon with its first vertex again at the end.
fn closed(polygon: &[Place]) -> Vec<Place> {
    polygon.iter().chain(polygon.first()).cloned().collect()
}

fn compare(face: &[Place], expected: Vec<Place>) {
    let found = new_face(face);
    let names: Vec<String> = face.iter().map(ToString::to_string).collect();
    claim("the new vertices")
        .input(names.join(", "))
        .picture(|| {
            Picture::new()
                .given(closed(face))
                .expected(closed(&expected))
                .found(closed(&found))
        })
        .equal(found.clone(), expected.clone());
}

/// Why: the weights 9, 3, 1, 3 over 16 are easily checked on paper.
#[test]
fn a_square() {
    compare(
        &places(&[[0, 0], [16, 0], [16, 16], [0, 16]]),
        places(&[[4, 4], [12, 4], [12, 12], [4, 12]]),
    );
}

/// Why: the sum of the weights by itself.
#[test]
fn equal_points() {
    for k in [3, 4, 6] {
        let face = places(&vec![[5, -2]; k]);
        compare(&face, face.clone());
    }
}

/// Why: a triangle has other weights than a square.
#[test]
fn a_triangle() {
    compare(
        &places(&[[0, 0], [12, 0], [0, 12]]),
        places(&[[2, 2], [8, 2], [2, 8]]),
    );
}

/// Why: a face that is no parallelogram does not only become smaller.
#[test]
fn a_trapezium() {
    let halves = [[7, 4], [21, 4], [15, 12], [5, 12]];
    let expected = halves.map(|p| Point::new(p.map(|n| BigRational::from_ratio(n, 2))));
    compare(&places(&TRAPEZIUM), expected.into());
}

proptest! {
    /// Why: any face with 3, 4 or 6 vertices, in exact numbers.
    #[test]
    fn exact(
        k in prop::sample::select(vec![3_usize, 4, 6]),
        coordinates in prop::collection::vec(any::<[i8; 2]>(), 6),
    ) {
        let coordinates: Vec<[i64; 2]> =
            coordinates.into_iter().take(k).map(|p| p.map(i64::from)).collect();
        let face = places(&coordinates);
        let expected = doo_sabin_face(&face).expect("three vertices or more");
        compare(&face, expected);
    }

    /// Why: a pentagon has irrational weights, but its centroid stays where it is.
    #[test]
    fn pentagon(coordinates in prop::array::uniform5(any::<[i8; 2]>())) {
        let face = coordinates.map(|p| Point::new(p.map(f64::from)));
        let expected = doo_sabin_face(&face).expect("three vertices or more");
        // Two sums of 5 terms up to 256 with at most 20 roundings each, on either side.
        claim("the new vertices of a pentagon").close(
            answer::new_face(&face, &cosines(5)),
            expected,
            2.0 * 5.0 * 256.0 * 20.0 * f64::EPSILON,
        );
    }
}
