//! misconception: each product of coefficients has a place of its own, so it is stored; but several of them meet at one power, and are added

use cagd::scalar::Scalar;

/// The mask of several steps.
pub fn steps<T: Scalar>(mask: &[T], count: usize) -> Vec<T> {
    (0..count).fold(vec![T::one()], |product, _| {
        let mut next = vec![T::zero(); mask.len() + 2 * (product.len() - 1)];
        for (i, a) in mask.iter().enumerate() {
            for (j, p) in product.iter().enumerate() {
                next[i + 2 * j] = a.clone() * p.clone();
            }
        }
        next
    })
}
