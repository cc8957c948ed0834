//! With a new list for every degree.

use cagd::scalar::Scalar;

/// The values B₀ⁿ(t), …, Bₙⁿ(t).
pub fn bernstein_values<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let mut values = vec![T::one()];
    for _ in 0..n {
        let above = std::iter::once(T::zero()).chain(values.iter().cloned());
        let same = values.iter().cloned().chain([T::zero()]);
        let step = |(same, above): (T, T)| s.clone() * same + t.clone() * above;
        values = same.zip(above).map(step).collect();
    }
    values
}
