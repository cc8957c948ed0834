//! misconception: a swap of the first two and a reversal of the list together reach every order, as they do for three arguments

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
    let with = |place: usize, number: T| {
        let mut arguments = x.to_vec();
        arguments[place] = number;
        arguments
    };
    let rest = T::one() - lambda.clone();
    let between = |u: &T| rest.clone() * u.clone() + lambda.clone() * v.clone();
    let mut sides = Sides::new(format!("x = {x:?}, v = {v}, λ = {lambda}"));
    let reversed: Vec<T> = x.iter().rev().cloned().collect();
    sides = sides.equal(
        "symmetric",
        [function(&reversed)],
        [function(x)],
        Rounding::none(),
    );
    if x.len() > 1 {
        let mut swapped = x.to_vec();
        swapped.swap(0, 1);
        sides = sides.equal(
            "symmetric",
            [function(&swapped)],
            [function(x)],
            Rounding::none(),
        );
    }
    let combination = rest.clone() * function(x) + lambda.clone() * function(&with(0, v.clone()));
    let affine = function(&with(0, between(&x[0])));
    let diagonal = vec![x[0].clone(); x.len()];
    sides
        .equal("affine", [affine], [combination], Rounding::none())
        .equal(
            "diagonal",
            [function(&diagonal)],
            [polynomial(&x[0])],
            Rounding::none(),
        )
}
