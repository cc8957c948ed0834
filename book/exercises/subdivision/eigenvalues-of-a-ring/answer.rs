//! The eigenvalues of a rule that is the same at each point of a ring.

use cagd::scalar::Scalar;

/// The eigenvalue for cos(2πfi/k), i = 0, …, k − 1, with f = `frequency`.
///
/// `row` holds a₀, …, aₖ₋₁ with aⱼ = aₖ₋ⱼ, and `cosines[j]` is cos(2πj/k).
pub fn eigenvalue<T: Scalar>(row: &[T], cosines: &[T], frequency: usize) -> T {
    //@ solution
    let k = row.len();
    (0..k).fold(T::zero(), |sum, j| {
        sum + row[j].clone() * cosines[(frequency * j) % k].clone()
    })
    //@ starter
    //| // Right for the frequency 0.
    //| let _ = (cosines, frequency);
    //| row.iter().fold(T::zero(), |sum, a| sum + a.clone())
    //@ end
}

/// The weights of the neighbours i, i + 1, …, i + k − 1 in the new neighbour i of Loop's scheme.
pub fn loop_row<T: Scalar>(k: usize) -> Vec<T> {
    let mut row = vec![T::zero(); k];
    row[0] = T::from_ratio(3, 8);
    //@ solution
    row[1] = T::from_ratio(1, 8);
    row[k - 1] = T::from_ratio(1, 8);
    //@ starter
    //| // Two neighbours are missing.
    //@ end
    row
}
