//! All three from the elementary symmetric polynomials of the library.

use cagd::bezier::{binomial, elementary_symmetric};
use cagd::scalar::Scalar;

fn blossom<T: Scalar>(k: usize, x: &[T; 4]) -> T {
    elementary_symmetric(x)[k].clone() / binomial::<T>(4, k as i64)
}

/// The blossom of X, read as a polynomial of degree at most 4.
pub fn blossom_of_x<T: Scalar>(x: &[T; 4]) -> T {
    blossom(1, x)
}

/// The blossom of X², read as a polynomial of degree at most 4.
pub fn blossom_of_x2<T: Scalar>(x: &[T; 4]) -> T {
    blossom(2, x)
}

/// The blossom of X⁴.
pub fn blossom_of_x4<T: Scalar>(x: &[T; 4]) -> T {
    blossom(4, x)
}
