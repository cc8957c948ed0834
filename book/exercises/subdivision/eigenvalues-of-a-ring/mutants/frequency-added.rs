//! misconception: the frequency shifts the angles; but it multiplies them: 2πfj/k

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
    (0..k).fold(T::zero(), |sum, j| {
        sum + row[j].clone() * cosines[(frequency + j) % k].clone()
    })
}
