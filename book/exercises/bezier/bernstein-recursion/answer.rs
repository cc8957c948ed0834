//! Bernstein polynomials by recursion.

use cagd::scalar::Scalar;

/// The values B₀ⁿ(t), …, Bₙⁿ(t).
pub fn bernstein_values<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let mut values = vec![T::one()];
    for j in 1..=n {
        //@ solution
        values.push(T::zero());
        for l in (1..=j).rev() {
            values[l] = s.clone() * values[l].clone() + t.clone() * values[l - 1].clone();
        }
        values[0] *= s.clone();
        //@ starter
        //| // One entry more, but its value is still missing.
        //| let _ = (j, &s, &t);
        //| values.push(T::zero());
        //@ end
    }
    values
}
