//! Wrong affine maps.

use cagd::affine::{Affine, AffineBasis, AffineMap, Line, Point, Vector, laws};
use cagd::scalar::{OrderedScalar, Scalar};

type Map<T> = AffineMap<T, 2, 2>;
type Place<T> = Point<T, 2>;

/// Treats points as vectors: the linear part alone.
pub fn translation_forgotten<T: Scalar, const D: usize, const E: usize>(
    map: &AffineMap<T, D, E>,
    point: &Point<T, D>,
) -> Point<T, E> {
    Point::origin().translated(&map.vector(&point.from_origin()))
}

/// Uses the columns of the matrix as rows.
pub fn transposed<T: Scalar>(map: &Map<T>, point: &Place<T>) -> Place<T> {
    let entry = |row: usize, column: usize| map.linear()[(column, row)].clone();
    let rows = [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]];
    let translation = [map.translation()[0].clone(), map.translation()[1].clone()];
    AffineMap::new(rows, translation).point(point)
}

/// Adds a term of second order.
pub fn bent<T: Scalar>(map: &Map<T>, point: &Place<T>) -> Place<T> {
    let image = map.point(point);
    Point::new([
        image[0].clone() + point[0].clone() * point[1].clone(),
        image[1].clone(),
    ])
}

/// Replaces a negative first coordinate by 0, as a screen does.
pub fn cut_off<T: OrderedScalar>(map: &Map<T>, point: &Place<T>) -> Place<T> {
    let image = map.point(point);
    let first = image[0].clone().max(T::zero());
    Point::new([first, image[1].clone()])
}

/// The constructors of the library.
pub fn library<T: OrderedScalar>() -> laws::MapExamples<T> {
    laws::MapExamples {
        scaling: AffineMap::scaling,
        homothety: AffineMap::homothety,
        rotation: AffineMap::rational_rotation,
        projection: |line, along| {
            AffineMap::parallel_projection(line, along).expect("a direction that leaves the line")
        },
    }
}

/// Uses one factor for both coordinates.
pub fn scaling_by_the_first_factor<T: Scalar>(factors: [T; 2]) -> Map<T> {
    let [first, _] = factors;
    AffineMap::scaling([first.clone(), first])
}

/// Scales from the origin, wherever the centre is.
pub fn homothety_from_the_origin<T: Scalar>(_: &Place<T>, factor: T) -> Map<T> {
    AffineMap::scaling([factor.clone(), factor])
}

/// Scales from the reflected centre.
pub fn homothety_with_the_centre_reflected<T: Scalar>(centre: &Place<T>, factor: T) -> Map<T> {
    let reflected = centre.map(|x| -x);
    AffineMap::homothety(&reflected, factor)
}

/// Turns clockwise.
pub fn clockwise<T: OrderedScalar>(q: T) -> Map<T> {
    AffineMap::rational_rotation(-q)
}

/// Has the sine in the wrong place: a reflection.
pub fn reflection<T: OrderedScalar>(q: T) -> Map<T> {
    let turn = AffineMap::rational_rotation(q);
    turn.after(&AffineMap::scaling([T::one(), -T::one()]))
}

/// Forgets to divide by 1 + q².
pub fn not_normalised<T: Scalar>(q: T) -> Map<T> {
    let square = q.clone() * q.clone();
    let (cosine, sine) = (T::one() - square, q.clone() + q);
    let rows = [[cosine.clone(), -sine.clone()], [sine, cosine]];
    AffineMap::new(rows, [T::zero(), T::zero()])
}

/// Projects onto the parallel through the origin.
pub fn offset_forgotten<T: Scalar>(line: &Line<T>, along: &Vector<T, 2>) -> Map<T> {
    let normal = [line.normal()[0].clone(), line.normal()[1].clone()];
    let parallel = Line::new(normal, T::zero()).expect("a line");
    AffineMap::parallel_projection(&parallel, along).expect("a direction that leaves the line")
}

/// Reflects in place of projecting.
pub fn reflected<T: Scalar>(line: &Line<T>, along: &Vector<T, 2>) -> Map<T> {
    let projection =
        AffineMap::parallel_projection(line, along).expect("a direction that leaves the line");
    let two = T::from_integer(2);
    let entry = |row: usize, column: usize| {
        let kept = if row == column { T::one() } else { T::zero() };
        two.clone() * projection.linear()[(row, column)].clone() - kept
    };
    let step = |k: usize| two.clone() * projection.translation()[k].clone();
    AffineMap::new(
        [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]],
        [step(0), step(1)],
    )
}

/// Gives the images to the points of the basis in the wrong order.
pub fn images_shifted<T: Scalar, const D: usize, const E: usize>(
    basis: &AffineBasis<T, D>,
    images: &[Point<T, E>],
) -> AffineMap<T, D, E> {
    let mut images = images.to_vec();
    images.rotate_left(1);
    AffineMap::from_images(basis, &images).expect("one image a point")
}

/// Takes the images of the edges for the map and forgets that the basis is not the standard one.
pub fn basis_ignored<T: Scalar, const D: usize, const E: usize>(
    _: &AffineBasis<T, D>,
    images: &[Point<T, E>],
) -> AffineMap<T, D, E> {
    AffineMap::from_images(&AffineBasis::standard(), images).expect("one image a point")
}

/// The product of the diagonal.
pub fn diagonal<T: Scalar, const D: usize>(map: &AffineMap<T, D, D>) -> T {
    (0..D).fold(T::one(), |product, k| {
        product * map.linear()[(k, k)].clone()
    })
}

/// The trace.
pub fn trace<T: Scalar, const D: usize>(map: &AffineMap<T, D, D>) -> T {
    (0..D).fold(T::zero(), |sum, k| sum + map.linear()[(k, k)].clone())
}

/// Forgets the sign.
pub fn absolute<T: OrderedScalar, const D: usize>(map: &AffineMap<T, D, D>) -> T {
    map.determinant().abs()
}

/// (1 − λ)·P + λ·Q, coordinate by coordinate.
pub fn interpolation<T: Scalar>(p: &[T], q: &[T], lambda: T) -> Vec<T> {
    std::iter::zip(p, q)
        .map(|(p, q)| p.lerp(q, lambda.clone()))
        .collect()
}

/// λ·P + (1 − λ)·Q.
pub fn weights_swapped<T: Scalar>(p: &[T], q: &[T], lambda: T) -> Vec<T> {
    interpolation(q, p, lambda)
}

/// P + λ·Q: forgets that the weights must sum to 1.
pub fn sum_of_points<T: Scalar>(p: &[T], q: &[T], lambda: T) -> Vec<T> {
    std::iter::zip(p, q)
        .map(|(p, q)| p.clone() + lambda.clone() * q.clone())
        .collect()
}

/// Eases in and out by a cubic in λ, but only in the first coordinate.
pub fn eased_in_one_coordinate<T: Scalar>(p: &[T], q: &[T], lambda: T) -> Vec<T> {
    let square = lambda.clone() * lambda.clone();
    let eased = T::from_integer(3) * square.clone() - T::from_integer(2) * square * lambda.clone();
    let mut point = interpolation(p, q, lambda);
    point[0] = p[0].lerp(&q[0], eased);
    point
}

/// Shears along the second axis.
pub fn upwards<T: Scalar>(a: T) -> Map<T> {
    let (zero, one) = (T::zero, T::one);
    AffineMap::new([[one(), zero()], [a, one()]], [zero(), zero()])
}

/// Stretches as well.
pub fn stretched<T: Scalar>(a: T) -> Map<T> {
    let (zero, one) = (T::zero, T::one);
    AffineMap::new([[one() + a.clone(), a], [zero(), one()]], [zero(), zero()])
}

/// Rotates in place of shearing: has −a in the other corner.
pub fn turned<T: Scalar>(a: T) -> Map<T> {
    let (zero, one) = (T::zero, T::one);
    AffineMap::new([[one(), a.clone()], [-a, one()]], [zero(), zero()])
}

/// Has b and c in each other's places.
pub fn entries_exchanged<T: Scalar>(a: T, b: T, c: T) -> AffineMap<T, 3, 3> {
    AffineMap::spatial_shear(a, c, b)
}

/// Shears one coordinate after the other, so that c acts on what a has moved.
pub fn one_after_the_other<T: Scalar>(a: T, b: T, c: T) -> AffineMap<T, 3, 3> {
    let zero = T::zero;
    AffineMap::spatial_shear(a, zero(), zero()).after(&AffineMap::spatial_shear(zero(), b, c))
}
