//! One path after the other, each written as the steps that lower the index.

use cagd::scalar::Scalar;

/// The number of paths from the control point bₖ to the tip of a triangle of degree n.
pub fn paths(n: usize, k: usize) -> u64 {
    (0..1_u32 << n)
        .filter(|steps| steps.count_ones() as usize == k)
        .count() as u64
}

/// The sum over all these paths of the product of the factors along the path.
pub fn weight<T: Scalar>(n: usize, k: usize, t: T) -> T {
    let product = |steps: u32| {
        (0..n).fold(T::one(), |product, step| {
            let lowers = steps >> step & 1 == 1;
            product
                * if lowers {
                    t.clone()
                } else {
                    T::one() - t.clone()
                }
        })
    };
    (0..1_u32 << n)
        .filter(|steps| steps.count_ones() as usize == k)
        .fold(T::zero(), |sum, steps| sum + product(steps))
}
