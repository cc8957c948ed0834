//! misconception: t and 1 - t may be exchanged, as both occur in every summand

use cagd::scalar::Scalar;

/// The values B₀ⁿ(t), …, Bₙⁿ(t).
pub fn bernstein_values<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let mut values = vec![T::one()];
    for j in 1..=n {
        values.push(T::zero());
        for l in (1..=j).rev() {
            values[l] = t.clone() * values[l].clone() + s.clone() * values[l - 1].clone();
        }
        values[0] *= t.clone();
    }
    values
}
