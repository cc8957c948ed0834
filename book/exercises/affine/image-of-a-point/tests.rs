use cagd::affine::{Affine, Point};
use cagd::check::{Picture, claim};
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Corners = [[i64; 2]; 3];

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn point(xy: [i64; 2]) -> Point<BigRational, 2> {
    Point::new(xy.map(|n| fraction(n, 1)))
}

fn probes() -> Vec<String> {
    let corners = [[1, 1], [5, 2], [2, 7]].map(point);
    let images = [[3, 0], [4, 9], [-2, 5]].map(point);
    let at = |xy| answer::image(&corners, &images, &point(xy));
    cagd::probes![
        at([3, 3]),
        at([-2, 4]),
        answer::image(
            &[[0, 0], [1, 1], [2, 2]].map(point),
            &images,
            &point([1, 1])
        ),
        answer::image(
            &corners,
            &[[0, 0], [1, 1], [2, 2]].map(point),
            &point([3, 3])
        ),
    ]
}

fn compare(
    corners: &[Point<BigRational, 2>; 3],
    images: &[Point<BigRational, 2>; 3],
    m: &Point<BigRational, 2>,
    expected: Option<Point<BigRational, 2>>,
) {
    let list = |points: &[Point<BigRational, 2>; 3]| {
        let [a, b, c] = points;
        format!("{a}, {b}, {c}")
    };
    let closed =
        |points: &[Point<BigRational, 2>; 3]| [0, 1, 2, 0].map(|k: usize| points[k].clone());
    let found = || answer::image(corners, images, m);
    claim("the image of M")
        .input(format!(
            "A, B, C = {}; A′, B′, C′ = {}; M = {m}",
            list(corners),
            list(images)
        ))
        .picture(|| {
            Picture::new()
                .given(closed(corners))
                .given([m.clone()])
                .given(closed(images))
                .expected(expected.clone())
                .found(found())
        })
        .equal(found(), expected.clone());
}

/// A triangle, where it goes, and where the point with these weights goes, in units of an eighth.
fn planted(corners: Corners, images: Corners, weights: [i64; 3]) {
    let (corners, images) = (corners.map(point), images.map(point));
    let combination = |points: &[Point<BigRational, 2>; 3]| {
        let terms = weights
            .map(|w| fraction(w, 8))
            .into_iter()
            .zip(points.clone());
        Point::affine_combination(terms).expect("the weights sum to 8")
    };
    compare(
        &corners,
        &images,
        &combination(&corners),
        Some(combination(&images)),
    );
}

/// Why: the corners go where the task says.
#[test]
fn corners() {
    for weights in [[8, 0, 0], [0, 8, 0], [0, 0, 8]] {
        planted([[0, 0], [4, 0], [0, 4]], [[1, 1], [1, 5], [-3, 1]], weights);
    }
}

/// Why: the three weights of the centroid are equal, so nobody can mix them up.
#[test]
fn centroid() {
    let (corners, images) = ([[0, 0], [3, 0], [0, 3]], [[1, 1], [1, 4], [-2, 1]]);
    compare(
        &corners.map(point),
        &images.map(point),
        &point([1, 1]),
        Some(point([0, 2])),
    );
}

/// Why: three different weights, in a triangle with a right angle.
#[test]
fn inside() {
    planted(
        [[0, 0], [8, 0], [0, 8]],
        [[0, 0], [16, 0], [0, 24]],
        [5, 2, 1],
    );
}

/// Why: outside of the triangle a weight is negative.
#[test]
fn outside() {
    for weights in [[-8, 8, 8], [16, -4, -4], [4, 12, -8]] {
        planted([[0, 0], [4, 0], [0, 4]], [[1, 1], [1, 5], [-3, 1]], weights);
    }
}

/// Three points of a line determine no map of the plane.
#[test]
fn corners_on_a_line() {
    let images = [[0, 0], [1, 0], [0, 1]].map(point);
    for corners in [
        [[0, 0], [1, 1], [3, 3]],
        [[1, 2], [1, 2], [4, 0]],
        [[2, 2]; 3],
    ] {
        compare(&corners.map(point), &images, &point([1, 1]), None);
    }
}

/// The images may lie on a line.
#[test]
fn images_on_a_line() {
    for images in [[[0, 0], [8, 8], [16, 16]], [[3, 1]; 3]] {
        planted([[0, 0], [4, 0], [0, 4]], images, [2, 1, 5]);
    }
}

proptest! {
    /// Why: any triangle of either orientation, any images, any point.
    #[test]
    fn everywhere(
        corners in any::<[[i8; 2]; 3]>(), images in any::<[[i8; 2]; 3]>(),
        beta in -12..=12_i64, gamma in -12..=12_i64,
    ) {
        let whole = |points: [[i8; 2]; 3]| points.map(|xy| xy.map(i64::from));
        let [a, b, c] = whole(corners);
        prop_assume!((b[0] - a[0]) * (c[1] - a[1]) != (b[1] - a[1]) * (c[0] - a[0]));
        planted(whole(corners), whole(images), [8 - beta - gamma, beta, gamma]);
    }
}
