//! misconception: the order in which the entries are replaced does not matter

use cagd::scalar::Scalar;

/// The values B₀ⁿ(t), …, Bₙⁿ(t).
pub fn bernstein_values<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let mut values = vec![T::one()];
    for j in 1..=n {
        values.push(T::zero());
        values[0] *= s.clone();
        for l in 1..=j {
            values[l] = s.clone() * values[l].clone() + t.clone() * values[l - 1].clone();
        }
    }
    values
}
