//! misconception: the blossom of a power is the mean of that power of the arguments

use cagd::scalar::Scalar;

/// The blossom of X, read as a polynomial of degree at most 4.
pub fn blossom_of_x<T: Scalar>(x: &[T; 4]) -> T {
    let [x1, x2, x3, x4] = x.clone();
    (x1 + x2 + x3 + x4) * T::from_ratio(1, 4)
}

/// The blossom of X², read as a polynomial of degree at most 4.
pub fn blossom_of_x2<T: Scalar>(x: &[T; 4]) -> T {
    let squares = x.clone().map(|number| number.clone() * number);
    blossom_of_x(&squares)
}

/// The blossom of X⁴.
pub fn blossom_of_x4<T: Scalar>(x: &[T; 4]) -> T {
    let squares = x.clone().map(|number| number.clone() * number);
    blossom_of_x2(&squares)
}
