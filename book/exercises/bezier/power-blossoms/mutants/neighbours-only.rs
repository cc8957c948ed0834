//! misconception: the products of neighbours, each with the next and the last with the first, are enough

use cagd::scalar::Scalar;

/// The blossom of X, read as a polynomial of degree at most 4.
pub fn blossom_of_x<T: Scalar>(x: &[T; 4]) -> T {
    let [x1, x2, x3, x4] = x.clone();
    (x1 + x2 + x3 + x4) * T::from_ratio(1, 4)
}

/// The blossom of X², read as a polynomial of degree at most 4.
pub fn blossom_of_x2<T: Scalar>(x: &[T; 4]) -> T {
    let [x1, x2, x3, x4] = x.clone();
    (x1.clone() * x2.clone() + x2 * x3.clone() + x3 * x4.clone() + x4 * x1) * T::from_ratio(1, 4)
}

/// The blossom of X⁴.
pub fn blossom_of_x4<T: Scalar>(x: &[T; 4]) -> T {
    let [x1, x2, x3, x4] = x.clone();
    x1 * x2 * x3 * x4
}
