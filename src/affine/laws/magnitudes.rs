//! Sizes of numbers, for the bounds of the laws.

use nalgebra::SMatrix;

use crate::scalar::Scalar;

/// The largest absolute value; 0 if there is no number.
pub(super) fn largest<'a, T: Scalar>(numbers: impl IntoIterator<Item = &'a T>) -> f64 {
    numbers
        .into_iter()
        .map(Scalar::magnitude)
        .fold(0.0, f64::max)
}

/// The largest sum of the absolute values of a row.
pub(super) fn row_sum<T: Scalar, const R: usize, const C: usize>(matrix: &SMatrix<T, R, C>) -> f64 {
    let sum = |row: usize| (0..C).map(|k| matrix[(row, k)].magnitude()).sum::<f64>();
    (0..R).map(sum).fold(0.0, f64::max)
}
