//! misconception: a control point beyond the last one counts like the last one

use cagd::scalar::Scalar;

/// The number of paths from the control point bₖ to the tip of a triangle of degree n.
pub fn paths(n: usize, k: usize) -> u64 {
    let k = k.min(n);
    match (n, k) {
        (0, 0) => 1,
        (_, 0) => paths(n - 1, 0),
        _ if k == n => paths(n - 1, k - 1),
        _ => paths(n - 1, k) + paths(n - 1, k - 1),
    }
}

/// The sum over all these paths of the product of the factors along the path.
pub fn weight<T: Scalar>(n: usize, k: usize, t: T) -> T {
    let k = k.min(n);
    let same = |t: T| (T::one() - t.clone()) * weight(n - 1, k, t);
    let lower = |t: T| t.clone() * weight(n - 1, k - 1, t);
    match (n, k) {
        (0, 0) => T::one(),
        (_, 0) => same(t),
        _ if k == n => lower(t),
        _ => same(t.clone()) + lower(t),
    }
}
