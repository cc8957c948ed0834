//! Blossoms with four arguments.

use cagd::scalar::Scalar;

/// The blossom of X, read as a polynomial of degree at most 4.
pub fn blossom_of_x<T: Scalar>(x: &[T; 4]) -> T {
    //@ solution
    let [x1, x2, x3, x4] = x.clone();
    (x1 + x2 + x3 + x4) * T::from_ratio(1, 4)
    //@ starter
    //| x[0].clone() // right on the diagonal, but only one argument counts
    //@ end
}

/// The blossom of X², read as a polynomial of degree at most 4.
pub fn blossom_of_x2<T: Scalar>(x: &[T; 4]) -> T {
    //@ solution
    let mut sum = T::zero();
    for i in 0..4 {
        for k in i + 1..4 {
            sum += x[i].clone() * x[k].clone();
        }
    }
    sum * T::from_ratio(1, 6)
    //@ starter
    //| x[0].clone() * x[1].clone() // two arguments are still without use
    //@ end
}

/// The blossom of X⁴.
pub fn blossom_of_x4<T: Scalar>(x: &[T; 4]) -> T {
    //@ solution
    let [x1, x2, x3, x4] = x.clone();
    x1 * x2 * x3 * x4
    //@ starter
    //| let square = x[0].clone() * x[0].clone();
    //| square.clone() * square // right on the diagonal, but not affine
    //@ end
}
