//! misconception: the factors have the arguments z, z², z⁴, z⁶, …; the exponents grow by 2 and do not double

use cagd::scalar::Scalar;

/// The mask of several steps.
pub fn steps<T: Scalar>(mask: &[T], count: usize) -> Vec<T> {
    let mut product = vec![T::one()];
    for k in 0..count {
        let stride = if k == 0 { 1 } else { 2 * k };
        let mut next = vec![T::zero(); product.len() + stride * (mask.len() - 1)];
        for (i, a) in mask.iter().enumerate() {
            for (j, p) in product.iter().enumerate() {
                next[stride * i + j] += a.clone() * p.clone();
            }
        }
        product = next;
    }
    product
}
