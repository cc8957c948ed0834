//! misconception: one path leads from a control point to the tip, so its weight is the product along it

use cagd::scalar::Scalar;

/// The number of paths from the control point bₖ to the tip of a triangle of degree n.
pub fn paths(n: usize, k: usize) -> u64 {
    u64::from(k <= n)
}

/// The sum over all these paths of the product of the factors along the path.
pub fn weight<T: Scalar>(n: usize, k: usize, t: T) -> T {
    if k > n {
        return T::zero();
    }
    let power = |x: T, k: usize| (0..k).fold(T::one(), |product, _| product * x.clone());
    power(t.clone(), k) * power(T::one() - t, n - k)
}
