//! misconception: the product begins with the symbol itself and then takes one factor a step, so it has one factor too many

use cagd::scalar::Scalar;

/// The mask of several steps.
pub fn steps<T: Scalar>(mask: &[T], count: usize) -> Vec<T> {
    let factors = if count == 0 { 0 } else { count + 1 };
    (0..factors).fold(vec![T::one()], |product, _| {
        let mut next = vec![T::zero(); mask.len() + 2 * (product.len() - 1)];
        for (i, a) in mask.iter().enumerate() {
            for (j, p) in product.iter().enumerate() {
                next[i + 2 * j] += a.clone() * p.clone();
            }
        }
        next
    })
}
