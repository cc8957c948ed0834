//! misconception: the first polynomial is the constant 1, as B₀⁰ = 1, and the recursion begins behind it

use cagd::scalar::Scalar;

/// The values B₀ⁿ(t), …, Bₙⁿ(t).
pub fn bernstein_values<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let mut values = vec![T::one()];
    for j in 1..=n {
        values.push(T::zero());
        for l in (1..=j).rev() {
            values[l] = s.clone() * values[l].clone() + t.clone() * values[l - 1].clone();
        }
    }
    values
}
