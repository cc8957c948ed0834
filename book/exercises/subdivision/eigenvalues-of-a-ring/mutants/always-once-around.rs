//! misconception: the points are cos(2πi/k), whatever the frequency is; but that is the frequency 1

use cagd::scalar::Scalar;

/// The weights of the neighbours in the new neighbour i of Loop's scheme.
pub fn loop_row<T: Scalar>(k: usize) -> Vec<T> {
    let mut row = vec![T::zero(); k];
    row[0] = T::from_ratio(3, 8);
    row[1] = T::from_ratio(1, 8);
    row[k - 1] = T::from_ratio(1, 8);
    row
}

/// The eigenvalue for cos(2πfi/k).
pub fn eigenvalue<T: Scalar>(row: &[T], cosines: &[T], frequency: usize) -> T {
    let k = row.len();
    let _ = frequency;
    (0..k).fold(T::zero(), |sum, j| {
        sum + row[j].clone() * cosines[j].clone()
    })
}
