//! The paths through the triangle of de Casteljau, and their weights.

use cagd::scalar::Scalar;

/// The number of paths from the control point bₖ to the tip of a triangle of degree n.
pub fn paths(n: usize, k: usize) -> u64 {
    //@ solution
    match (n, k) {
        (0, 0) => 1,
        _ if k > n => 0,
        (_, 0) => paths(n - 1, 0),
        _ => paths(n - 1, k) + paths(n - 1, k - 1),
    }
    //@ starter
    //| // The first step still has to be taken.
    //| match (n, k) {
    //|     (0, 0) => 1,
    //|     _ => 0,
    //| }
    //@ end
}

/// The sum over all these paths of the product of the factors along the path.
pub fn weight<T: Scalar>(n: usize, k: usize, t: T) -> T {
    //@ solution
    let same = |t: T| (T::one() - t.clone()) * weight(n - 1, k, t);
    match (n, k) {
        (0, 0) => T::one(),
        _ if k > n => T::zero(),
        (_, 0) => same(t),
        _ => same(t.clone()) + t.clone() * weight(n - 1, k - 1, t),
    }
    //@ starter
    //| let _ = t;
    //| match (n, k) {
    //|     (0, 0) => T::one(),
    //|     _ => T::zero(),
    //| }
    //@ end
}
