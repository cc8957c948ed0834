use cagd::affine::Point;
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Place = Point<BigRational, 3>;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn place(coordinates: [i64; 3]) -> Place {
    Point::new(coordinates.map(|n| fraction(n, 1)))
}

/// The weights β of the valences 3, 4 and 6.
fn beta(valence: usize) -> BigRational {
    match valence {
        3 => fraction(3, 16),
        4 => fraction(31, 256),
        _ => fraction(1, 16),
    }
}

fn probes() -> Vec<String> {
    let v = place([1, 2, 3]);
    let ring = [[4, 0, 0], [0, 5, 0], [0, 0, 7], [-2, 1, 1]].map(place);
    cagd::probes![
        answer::limit_point(&v, &ring[..3], &beta(3)),
        answer::limit_point(&v, &ring, &beta(4)),
    ]
}

/// (ωv + Σ nⱼ)/(ω + k) by coordinates, for the weights 2, 96/31 and 6.
fn compare(v: &Place, ring: &[Place]) {
    let k = ring.len();
    let omega = match k {
        3 => fraction(2, 1),
        4 => fraction(96, 31),
        _ => fraction(6, 1),
    };
    let right = Point::new([0, 1, 2].map(|axis: usize| {
        let sum = ring.iter().fold(omega.clone() * v[axis].clone(), |sum, n| {
            sum + n[axis].clone()
        });
        sum / (omega.clone() + fraction(k as i64, 1))
    }));
    claim("the limit position")
        .input(format!("v = {v}, neighbours {ring:?}, β = {}", beta(k)))
        .equal(answer::limit_point(v, ring, &beta(k)), right);
}

/// Why: a check of the weights' sum: a vertex in the middle of its neighbours stays there, whatever β is.
#[test]
fn in_the_middle() {
    let ring = [[3, 1, 1], [-1, 1, 1], [1, 1, 1]].map(place);
    compare(&place([1, 1, 1]), &ring);
}

/// Why: the vertex of the octahedron has neighbours with the sum 0, so only its own weight is seen, 24/55.
#[test]
fn octahedron() {
    let ring = [[0, 1, 0], [0, 0, 1], [0, -1, 0], [0, 0, -1]].map(place);
    compare(&place([1, 0, 0]), &ring);
}

/// Why: the regular case is the one that most books print.
#[test]
fn six_neighbours() {
    let ring = [
        [1, 0, 0],
        [1, 1, 0],
        [0, 1, 0],
        [-1, 0, 0],
        [-1, -1, 0],
        [0, -1, 0],
    ]
    .map(place);
    compare(&place([0, 0, 12]), &ring);
}

proptest! {
    /// Why: it rejects what is right for particular points only.
    #[test]
    fn anywhere(
        v in any::<[i8; 3]>(),
        k in prop::sample::select(vec![3_usize, 4, 6]),
        ring in prop::collection::vec(any::<[i8; 3]>(), 6),
    ) {
        let ring: Vec<Place> = ring.into_iter().take(k).map(|p| place(p.map(i64::from))).collect();
        compare(&place(v.map(i64::from)), &ring);
    }
}
