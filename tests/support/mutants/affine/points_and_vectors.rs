//! Mistakes with points and vectors.

use cagd::affine::{Affine, Linear};
use num_traits::Zero;

/// Goes the way twice.
pub fn moved_twice<P: Affine>(point: &P, vector: &P::Difference) -> P {
    point.translated(vector).translated(vector)
}

/// Translates the first coordinate only.
pub fn first_coordinate_moved<P: Affine>(point: &P, vector: &P::Difference) -> P {
    let moved = point.translated(vector);
    P::from_fn(|k| {
        let from = if k == 0 { &moved } else { point };
        from.coordinates()[k].clone()
    })
}

/// Takes the vector from the end to the start.
pub fn difference_reversed<P: Affine>(end: &P, start: &P) -> P::Difference {
    start.difference(end)
}

/// Takes the position vector of the end for the vector to the end.
pub fn start_forgotten<P: Affine>(end: &P, _: &P) -> P::Difference {
    P::Difference::from_fn(|k| end.coordinates()[k].clone())
}

/// Multiplies the coordinates, as if the origin of the reader did not matter.
pub fn coordinates_multiplied<P: Affine>(_: &P, factor: &P::Scalar, point: &P) -> P {
    P::from_fn(|k| point.coordinates()[k].clone() * factor.clone())
}

/// Goes λ times the way from the origin, but begins at the point.
pub fn begun_at_the_point<P: Affine>(origin: &P, factor: &P::Scalar, point: &P) -> P {
    point.translated(&point.difference(origin).scaled(factor.clone()))
}

/// Leaves out the origin after taking the way from it.
pub fn origin_not_added<P: Affine>(origin: &P, factor: &P::Scalar, point: &P) -> P {
    P::from_fn(|_| P::Scalar::zero()).translated(&point.difference(origin).scaled(factor.clone()))
}
