//! misconception: the blossom of a power has as many arguments as the exponent says; the others are not used

use cagd::scalar::Scalar;

/// The blossom of X, read as a polynomial of degree at most 4.
pub fn blossom_of_x<T: Scalar>(x: &[T; 4]) -> T {
    x[0].clone()
}

/// The blossom of X², read as a polynomial of degree at most 4.
pub fn blossom_of_x2<T: Scalar>(x: &[T; 4]) -> T {
    x[0].clone() * x[1].clone()
}

/// The blossom of X⁴.
pub fn blossom_of_x4<T: Scalar>(x: &[T; 4]) -> T {
    let [x1, x2, x3, x4] = x.clone();
    x1 * x2 * x3 * x4
}
