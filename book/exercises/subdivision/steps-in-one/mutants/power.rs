//! misconception: two steps multiply the symbol by itself; the argument z² is forgotten

use cagd::scalar::Scalar;

/// The mask of several steps.
pub fn steps<T: Scalar>(mask: &[T], count: usize) -> Vec<T> {
    (0..count).fold(vec![T::one()], |product, _| {
        let mut next = vec![T::zero(); mask.len() + product.len() - 1];
        for (i, a) in mask.iter().enumerate() {
            for (j, p) in product.iter().enumerate() {
                next[i + j] += a.clone() * p.clone();
            }
        }
        next
    })
}
