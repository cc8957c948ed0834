//! Wrong four-point schemes.

use cagd::affine::{Affine, Point};
use cagd::scalar::{BigRational, OrderedScalar, Scalar};
use cagd::subdivision::{
    ControlPolygon, ControlPolygonError, LaurentPolynomial, LocalMatrix, Mask,
};
use num_traits::{One, Zero};

type Refined<P> = Result<ControlPolygon<P>, ControlPolygonError>;

/// Turns the sign of the tension.
pub fn sign_of_tension<P: Affine>(polygon: &ControlPolygon<P>, w: P::Scalar) -> Refined<P> {
    polygon.four_point(-w)
}

/// Always takes 1/16.
pub fn always_a_sixteenth<P: Affine>(polygon: &ControlPolygon<P>, _: P::Scalar) -> Refined<P> {
    polygon.four_point(P::Scalar::from_ratio(1, 16))
}

/// Inserts midpoints.
pub fn midpoints<P: Affine>(polygon: &ControlPolygon<P>, _: P::Scalar) -> Refined<P> {
    polygon.four_point(P::Scalar::zero())
}

/// Puts each new point into the leg before.
pub fn one_leg_off<P: Affine>(polygon: &ControlPolygon<P>, w: P::Scalar) -> Refined<P> {
    let refined = polygon.four_point(w)?;
    let mut points = refined.vertices().to_vec();
    for i in (3..points.len()).step_by(2) {
        points.swap(i - 2, i);
    }
    ControlPolygon::new(points, refined.closing())
}

/// Moves the old points too: takes the middle of each leg of the refined polygon.
pub fn old_points_moved<P: Affine>(polygon: &ControlPolygon<P>, w: P::Scalar) -> Refined<P> {
    polygon.four_point(w)?.averaged()
}

/// The weights as the Compendium prints them: (1/2)·w for 1/2 + w before the third point.
pub fn printed_weights(w: BigRational) -> Option<Mask<BigRational>> {
    let half = BigRational::from_ratio(1, 2);
    let zero = BigRational::zero();
    Mask::new(
        -3,
        [
            -w.clone(),
            zero.clone(),
            &half + &w,
            BigRational::one(),
            half * &w,
            zero,
            -w,
        ],
    )
    .ok()
}

/// Half the tension.
pub fn half_the_tension(w: BigRational) -> Option<Mask<BigRational>> {
    Mask::four_point(w * BigRational::from_ratio(1, 2)).ok()
}

/// The weights of a tension with the wrong sign.
pub fn negative_tension(w: BigRational) -> Option<Mask<BigRational>> {
    Mask::four_point(-w).ok()
}

/// Leaves one step out.
pub fn one_step_fewer(mask: &Mask<BigRational>, steps: usize) -> BigRational {
    mask.norm(steps - 1)
}

/// Sums all coefficients, not those of one rule.
pub fn all_rules_together(mask: &Mask<BigRational>, steps: usize) -> BigRational {
    let symbol: LaurentPolynomial<BigRational> = mask.steps(steps);
    let sizes = symbol.coefficients().iter().map(OrderedScalar::abs);
    sizes.sum::<BigRational>()
}

/// The matrix of the differences instead of that of the points.
pub fn matrix_of_differences(mask: &Mask<BigRational>) -> LocalMatrix<BigRational> {
    LocalMatrix::of(
        &mask
            .difference_scheme()
            .expect("a symbol with a factor 1 + z"),
    )
}

/// Computes the first coordinate twice.
pub fn first_coordinate_twice<T: Scalar>(
    mask: &Mask<T>,
    points: &[Point<T, 2>],
) -> Option<Vec<Point<T, 2>>> {
    let refined = mask.refine_closed(points).ok()?;
    let doubled = refined
        .iter()
        .map(|p| Point::new([p[0].clone(), p[0].clone()]));
    Some(doubled.collect())
}

/// Moves the new points of odd index off by a fixed vector.
pub fn pushed_off<T: Scalar>(mask: &Mask<T>, points: &[Point<T, 2>]) -> Option<Vec<Point<T, 2>>> {
    let mut refined = mask.refine_closed(points).ok()?;
    for point in refined.iter_mut().skip(1).step_by(2) {
        *point = Point::new([point[0].clone(), point[1].clone() + T::one()]);
    }
    Some(refined)
}

/// Weights that do not sum to 1: everything is drawn towards the origin.
pub fn towards_the_origin<T: Scalar>(
    mask: &Mask<T>,
    points: &[Point<T, 2>],
) -> Option<Vec<Point<T, 2>>> {
    let refined = mask.refine_closed(points).ok()?;
    let half = T::from_ratio(1, 2);
    let drawn = refined
        .iter()
        .map(|p| Point::origin() + p.from_origin() * half.clone());
    Some(drawn.collect())
}
