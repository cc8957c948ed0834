//! misconception: an affine function takes sums to sums, p(u + v, …) = p(u, …) + p(v, …); that is a linear one

use cagd::law::{Rounding, Sides};
use cagd::scalar::Scalar;

/// Claims that `function` is the blossom of `polynomial`, as far as it can be seen at x, v and λ.
pub fn law<T: Scalar>(
    function: impl Fn(&[T]) -> T,
    polynomial: impl Fn(&T) -> T,
    x: &[T],
    v: &T,
    lambda: &T,
) -> Sides<T> {
    let _ = lambda;
    let with = |place: usize, number: T| {
        let mut arguments = x.to_vec();
        arguments[place] = number;
        arguments
    };
    let mut sides = Sides::new(format!("x = {x:?}, v = {v}, λ = {lambda}"));
    for i in 1..x.len() {
        let mut swapped = x.to_vec();
        swapped.swap(i - 1, i);
        sides = sides.equal(
            "symmetric",
            [function(&swapped)],
            [function(x)],
            Rounding::none(),
        );
    }
    let sum = function(x) + function(&with(0, v.clone()));
    let affine = function(&with(0, x[0].clone() + v.clone()));
    let diagonal = vec![x[0].clone(); x.len()];
    sides
        .equal("linear", [affine], [sum], Rounding::none())
        .equal(
            "diagonal",
            [function(&diagonal)],
            [polynomial(&x[0])],
            Rounding::none(),
        )
}
