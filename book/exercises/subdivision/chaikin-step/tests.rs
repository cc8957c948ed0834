use cagd::affine::Point;
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type RationalPoint = Point<BigRational, 2>;

fn points(coordinates: &[[i64; 2]]) -> Vec<RationalPoint> {
    let point = |xy: &[i64; 2]| Point::new(xy.map(|n| BigRational::from_ratio(n, 1)));
    coordinates.iter().map(point).collect()
}

/// The midpoints of the legs.
fn averaged(vertices: &[RationalPoint]) -> Vec<RationalPoint> {
    let half = BigRational::from_ratio(1, 2);
    vertices
        .windows(2)
        .map(|leg| leg[0].clone() + (leg[1].clone() - leg[0].clone()) * half.clone())
        .collect()
}

/// Every vertex twice, then two averagings: another way to the same polygon.
fn expected(vertices: &[RationalPoint]) -> Vec<RationalPoint> {
    let doubled: Vec<RationalPoint> = vertices
        .iter()
        .flat_map(|vertex| [vertex.clone(), vertex.clone()])
        .collect();
    averaged(&averaged(&doubled))
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::chaikin(&points(&[[0, 0], [4, 8], [8, 0]])),
        answer::chaikin(&points(&[[1, 1]])),
    ]
}

fn compare(vertices: &[RationalPoint]) {
    let right = expected(vertices);
    claim("the polygon after one step")
        .input(format!("{vertices:?}"))
        .picture(|| {
            Picture::new()
                .given(vertices.to_vec())
                .expected(right.clone())
                .found(answer::chaikin(vertices))
        })
        .equal(answer::chaikin(vertices), right.clone());
}

/// Why: a single leg shows whether the cuts are in the right places and in the right order.
#[test]
fn one_leg() {
    compare(&points(&[[0, 0], [4, 8]]));
}

/// Why: without a leg there is nothing to cut.
#[test]
fn no_leg() {
    let none: Vec<RationalPoint> = Vec::new();
    claim("a single vertex").equal(answer::chaikin(&points(&[[3, 5]])), none.clone());
    claim("no vertex").equal(answer::chaikin::<BigRational>(&[]), none);
}

proptest! {
    /// Why: an open polygon with corners shows whether the ends are cut and no leg is invented.
    #[test]
    fn any_polygon(coordinates in prop::collection::vec([-8..=8_i64, -8..=8_i64], 3..7)) {
        compare(&points(&coordinates));
    }
}
