//! misconception: a Bernstein polynomial is a product of powers of t and 1 - t and nothing else

use cagd::scalar::Scalar;

/// The values B₀ⁿ(t), …, Bₙⁿ(t).
pub fn bernstein_values<T: Scalar>(n: usize, t: T) -> Vec<T> {
    let s = T::one() - t.clone();
    let power = |x: &T, k: usize| (0..k).fold(T::one(), |product, _| product * x.clone());
    (0..=n).map(|l| power(&t, l) * power(&s, n - l)).collect()
}
