//! misconception: a function is symmetric if its value stays when the arguments are moved round in a circle

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
    let mut turned = x.to_vec();
    turned.rotate_left(1);
    sides = sides.equal(
        "symmetric",
        [function(&turned)],
        [function(x)],
        Rounding::none(),
    );
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
