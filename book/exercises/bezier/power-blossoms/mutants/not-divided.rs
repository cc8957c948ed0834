//! misconception: the blossom is the sum of all products; that there are several of them does not matter on the diagonal

use cagd::scalar::Scalar;

/// The blossom of X, read as a polynomial of degree at most 4.
pub fn blossom_of_x<T: Scalar>(x: &[T; 4]) -> T {
    let [x1, x2, x3, x4] = x.clone();
    x1 + x2 + x3 + x4
}

/// The blossom of X², read as a polynomial of degree at most 4.
pub fn blossom_of_x2<T: Scalar>(x: &[T; 4]) -> T {
    let pairs = (0..4).flat_map(|i| (i + 1..4).map(move |k| (i, k)));
    let sum = pairs.fold(T::zero(), |sum, (i, k)| sum + x[i].clone() * x[k].clone());
    sum
}

/// The blossom of X⁴.
pub fn blossom_of_x4<T: Scalar>(x: &[T; 4]) -> T {
    let [x1, x2, x3, x4] = x.clone();
    x1 * x2 * x3 * x4
}
