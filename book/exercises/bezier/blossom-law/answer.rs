//! The definition of the blossom as a law.

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
    let sides = Sides::new(format!("x = {x:?}, v = {v}, λ = {lambda}"));
    //@ solution
    let value = function(x);
    let with_first = |first: T| {
        let mut arguments = x.to_vec();
        arguments[0] = first;
        function(&arguments)
    };
    let mut sides = sides;
    for i in 1..x.len() {
        let mut swapped = x.to_vec();
        swapped.swap(i - 1, i);
        sides = sides.equal(
            "symmetric",
            [function(&swapped)],
            [value.clone()],
            Rounding::none(),
        );
    }
    let rest = T::one() - lambda.clone();
    let between = rest.clone() * x[0].clone() + lambda.clone() * v.clone();
    let combination = rest * value + lambda.clone() * with_first(v.clone());
    let diagonal = vec![x[0].clone(); x.len()];
    sides
        .equal(
            "affine",
            [with_first(between)],
            [combination],
            Rounding::none(),
        )
        .equal(
            "diagonal",
            [function(&diagonal)],
            [polynomial(&x[0])],
            Rounding::none(),
        )
    //@ starter
    //| // Only the diagonal so far.
    //| let diagonal = vec![x[0].clone(); x.len()];
    //| sides.equal("diagonal", [function(&diagonal)], [polynomial(&x[0])], Rounding::none())
    //@ end
}
