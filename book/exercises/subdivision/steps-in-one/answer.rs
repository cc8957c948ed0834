//! The mask of several steps of a scheme.

use cagd::scalar::Scalar;

/// The coefficients of a(z)·a(z²)·a(z⁴)⋯, with `count` factors, beginning with that of z⁰.
///
/// `mask` holds a₀, …, aₘ and is not empty.
pub fn steps<T: Scalar>(mask: &[T], count: usize) -> Vec<T> {
    //@ solution
    (0..count).fold(vec![T::one()], |product, _| {
        let length = mask.len() + 2 * (product.len() - 1);
        let mut next = vec![T::zero(); length];
        for (i, a) in mask.iter().enumerate() {
            for (j, p) in product.iter().enumerate() {
                next[i + 2 * j] += a.clone() * p.clone();
            }
        }
        next
    })
    //@ starter
    //| // Right for one step.
    //| let _ = count;
    //| mask.to_vec()
    //@ end
}
