//! Swaps any two arguments and claims affinity in every one.

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
    for i in 0..x.len() {
        for k in 0..i {
            let mut swapped = x.to_vec();
            swapped.swap(i, k);
            sides = sides.equal(
                "symmetric",
                [function(x)],
                [function(&swapped)],
                Rounding::none(),
            );
        }
        let combination =
            rest.clone() * function(x) + lambda.clone() * function(&with(i, v.clone()));
        let affine = function(&with(i, between(&x[i])));
        sides = sides.equal("affine", [affine], [combination], Rounding::none());
    }
    for t in x {
        let diagonal = vec![t.clone(); x.len()];
        sides = sides.equal(
            "diagonal",
            [function(&diagonal)],
            [polynomial(t)],
            Rounding::none(),
        );
    }
    sides
}
