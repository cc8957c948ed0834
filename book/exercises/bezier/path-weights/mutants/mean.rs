//! misconception: the weight of the control point is the mean over its paths

use cagd::scalar::Scalar;

/// The number of paths from the control point bₖ to the tip of a triangle of degree n.
pub fn paths(n: usize, k: usize) -> u64 {
    match (n, k) {
        (0, 0) => 1,
        _ if k > n => 0,
        (_, 0) => paths(n - 1, 0),
        _ => paths(n - 1, k) + paths(n - 1, k - 1),
    }
}

/// The sum over all these paths of the product of the factors along the path.
pub fn weight<T: Scalar>(n: usize, k: usize, t: T) -> T {
    match paths(n, k) {
        0 => T::zero(),
        count => total(n, k, t) / T::from_integer(count as i64),
    }
}

fn total<T: Scalar>(n: usize, k: usize, t: T) -> T {
    let same = |t: T| (T::one() - t.clone()) * total(n - 1, k, t);
    match (n, k) {
        (0, 0) => T::one(),
        _ if k > n => T::zero(),
        (_, 0) => same(t),
        _ => same(t.clone()) + t.clone() * total(n - 1, k - 1, t),
    }
}
