//! Laws of Loop's scheme.

use crate::law::{Rounding, Sides};
use crate::scalar::OrderedScalar;
use crate::subdivision::{CosineOfTurn, LatticeMask};

/// `subdivision-loop-box-spline`: on regular meshes Loop's scheme has the symbol of the box spline M₂₂₂, and that is its limit.
///
/// `mask` must be the scheme on the lattice, `spline(x)` the value M₂₂₂(x) with the centre at the origin.
/// The claims: the symbol is 4((1 + x)/2)²((1 + y)/2)²((1 + xy)/2)²/(x²y²), its four classes sum to 1,
/// M(x) = Σ a_j M(2x − j), Σ M(x − j) = 1 and M ≥ 0, and the values at lattice points are 1/2, 1/12 and 0.
///
/// # Rounding
///
/// A value of M is a sum of 27 products of at most 9 operations whose absolute values sum to at most 2300;
/// with the 19 coefficients of the mask, which sum to 4, or over the at most 25 places where M(x − j) is not 0.
pub fn loop_box_spline<T: OrderedScalar + CosineOfTurn>(
    mask: &LatticeMask<T>,
    spline: impl Fn(&[T; 2]) -> T,
    x: &[T; 2],
) -> Sides<T> {
    const VALUE: f64 = 2300.0;
    let symbol = LatticeMask::three_direction([2, 2, 2]).shifted([-2, -2]);
    let square = || (-2..=2_i64).flat_map(|i| (-2..=2_i64).map(move |j| [i, j]));
    let numbers = |mask: &LatticeMask<T>| -> Vec<T> {
        let wide = (-3..=3).flat_map(|i| (-3..=3).map(move |j| [i, j]));
        wide.map(|index| mask.coefficient(index)).collect()
    };
    let at = |scale: i64, minus: [i64; 2]| {
        let coordinate =
            |k: usize| T::from_integer(scale) * x[k].clone() - T::from_integer(minus[k]);
        spline(&[coordinate(0), coordinate(1)])
    };
    let sum = |terms: &mut dyn Iterator<Item = T>| terms.fold(T::zero(), |sum, term| sum + term);
    let refined = sum(&mut mask.terms().map(|(j, a)| a.clone() * at(2, j)));
    // M(x − j) is not 0 only where j is less than 2 away from x.
    let near = |k: usize| x[k].to_f64().floor() as i64;
    let partition = sum(&mut (-2..=3).flat_map(|i| {
        let at = &at;
        (-2..=3).map(move |j| at(1, [near(0) + i, near(1) + j]))
    }));
    let at_lattice = square().map(|index| spline(&index.map(T::from_integer)));
    let values = square().map(|index| match index {
        [0, 0] => T::from_ratio(1, 2),
        [1, 0] | [0, 1] | [1, 1] | [-1, 0] | [0, -1] | [-1, -1] => T::from_ratio(1, 12),
        _ => T::zero(),
    });
    Sides::new(format!("x = ({}, {})", x[0], x[1]))
        .equal(
            "the coefficients are those of the symbol",
            numbers(mask),
            numbers(&symbol),
            Rounding::new(8, 4.0),
        )
        .equal(
            "the coefficients of each class sum to 1",
            mask.coset_sums(),
            [T::one(), T::one(), T::one(), T::one()],
            Rounding::new(12, 1.0),
        )
        .equal(
            "M(x) = Σ a_j M(2x − j)",
            [at(1, [0, 0])],
            [refined],
            Rounding::new(60, 5.0 * VALUE),
        )
        .equal(
            "Σ M(x − j) = 1",
            [partition],
            [T::one()],
            Rounding::new(72, 25.0 * VALUE),
        )
        .at_most(
            "M(x) ≥ 0",
            [T::zero()],
            [at(1, [0, 0])],
            Rounding::new(36, VALUE),
        )
        .equal(
            "the values at lattice points are 1/2, 1/12 and 0",
            at_lattice,
            values,
            Rounding::new(36, VALUE),
        )
}
