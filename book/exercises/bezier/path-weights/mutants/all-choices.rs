//! misconception: each of the n steps has two choices, so there are 2ⁿ paths from every control point

use cagd::scalar::Scalar;

/// The number of paths from the control point bₖ to the tip of a triangle of degree n.
pub fn paths(n: usize, k: usize) -> u64 {
    match k {
        _ if k > n => 0,
        _ => 2_u64.pow(n as u32),
    }
}

/// The sum over all these paths of the product of the factors along the path.
pub fn weight<T: Scalar>(n: usize, k: usize, t: T) -> T {
    let same = |t: T| (T::one() - t.clone()) * weight(n - 1, k, t);
    match (n, k) {
        (0, 0) => T::one(),
        _ if k > n => T::zero(),
        (_, 0) => same(t),
        _ => same(t.clone()) + t.clone() * weight(n - 1, k - 1, t),
    }
}
