//! Each old point is shared out between two new ones, as in the proof.

use cagd::affine::{Point, Vector};
use cagd::scalar::Scalar;

/// The control points of degree n + 1 of the curve with the control points b, at least one.
pub fn elevated<T: Scalar>(b: &[Point<T, 2>]) -> Vec<Point<T, 2>> {
    let whole = b.len() as i64;
    let mut sums = vec![Vector::<T, 2>::zeros(); b.len() + 1];
    for (i, point) in b.iter().enumerate() {
        let taken = i as i64 + 1;
        sums[i] += point.from_origin() * T::from_ratio(whole - i as i64, whole);
        sums[i + 1] += point.from_origin() * T::from_ratio(taken, whole);
    }
    sums.into_iter().map(|sum| Point::origin() + sum).collect()
}
