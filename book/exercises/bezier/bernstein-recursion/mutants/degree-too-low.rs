//! misconception: n values are asked for, and they belong to degree n - 1

use cagd::scalar::Scalar;

/// The values B₀ⁿ(t), …, Bₙⁿ(t).
pub fn bernstein_values<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let mut values = vec![T::one()];
    for j in 1..n {
        values.push(T::zero());
        for l in (1..=j).rev() {
            values[l] = s.clone() * values[l].clone() + t.clone() * values[l - 1].clone();
        }
        values[0] *= s.clone();
    }
    values
}
