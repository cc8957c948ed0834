//! Wrong steps, sum rules, difference schemes and proofs of smoothness.

use cagd::scalar::{BigRational, OrderedScalar, Scalar};
use cagd::subdivision::{Contraction, LaurentPolynomial, Mask, Smoothness};
use num_traits::Zero;

type Sequence = LaurentPolynomial<BigRational>;

/// Forgets that the data move apart: a(z)·p(z).
pub fn not_stretched(mask: &Mask<BigRational>, data: &Sequence) -> Sequence {
    mask.symbol() * data
}

/// Takes the coefficients backwards: Σ a₂ⱼ₋ᵢ pⱼ.
pub fn index_reversed(mask: &Mask<BigRational>, data: &Sequence) -> Sequence {
    let support = mask.support();
    let backwards = mask.symbol().coefficients().iter().rev().cloned();
    let reversed = Mask::new(1 - support.end, backwards).expect("the same coefficients");
    reversed.apply(data)
}

/// Uses the even rule for every new point.
pub fn even_rule_only(mask: &Mask<BigRational>, data: &Sequence) -> Sequence {
    let refined = mask.apply(data);
    let even = |i: i64| refined.coefficient(i - i.rem_euclid(2));
    LaurentPolynomial::new(refined.powers().start, refined.powers().map(even))
}

/// Counts zeros at 1 instead of −1.
pub fn zeros_at_one(mask: &Mask<BigRational>) -> usize {
    let minus_one = <BigRational as Scalar>::from_integer(-1);
    let quotients = std::iter::successors(Some(mask.symbol().clone()), |p| {
        p.divided_by_one_plus(minus_one.clone())
    });
    quotients.skip(1).count()
}

/// Counts one factor too few: the degree that is kept, not the number of rules.
pub fn degree_not_number(mask: &Mask<BigRational>) -> usize {
    mask.sum_rules().saturating_sub(1)
}

/// Is content with weights of sum 1.
pub fn affine_is_enough(mask: &Mask<BigRational>) -> usize {
    usize::from(mask.is_affine())
}

/// Divides by 1 − z.
pub fn divided_by_one_minus_z(mask: &Mask<BigRational>) -> Option<Mask<BigRational>> {
    let minus_one = <BigRational as Scalar>::from_integer(-1);
    Mask::from_symbol(mask.symbol().divided_by_one_plus(minus_one)?).ok()
}

/// Takes the scheme of the divided differences for that of the differences.
pub fn scaled_by_two(mask: &Mask<BigRational>) -> Option<Mask<BigRational>> {
    mask.divided_difference_scheme(1)
}

/// Takes the largest coefficient for the norm.
pub fn largest_coefficient(mask: &Mask<BigRational>, steps: usize) -> BigRational {
    let symbol = mask.steps(steps);
    let sizes = symbol.coefficients().iter().map(OrderedScalar::abs);
    sizes.fold(BigRational::zero(), OrderedScalar::max)
}

/// Sums without absolute values.
pub fn signed_sums(mask: &Mask<BigRational>, steps: usize) -> BigRational {
    let symbol = mask.steps(steps);
    let stride = 1 << steps;
    let sum =
        |r: usize| -> BigRational { symbol.coefficients().iter().skip(r).step_by(stride).sum() };
    (0..stride)
        .map(sum)
        .fold(BigRational::zero(), OrderedScalar::max)
}

/// Raises the norm of one step to a power.
pub fn power_of_the_norm(mask: &Mask<BigRational>, steps: usize) -> BigRational {
    let one = mask.norm(1);
    (1..steps).fold(one.clone(), |power, _| power * &one)
}

/// Believes that every factor 1 + z is a degree of smoothness.
pub fn factors_alone(mask: &Mask<BigRational>) -> Option<Smoothness<BigRational>> {
    let order = mask.sum_rules().checked_sub(1)?;
    let difference_scheme = mask.divided_difference_scheme(order)?.difference_scheme()?;
    Some(Smoothness {
        order,
        contraction: Contraction {
            steps: 1,
            norm: difference_scheme.norm(1),
        },
        difference_scheme,
    })
}

/// Tries a single step only.
pub fn one_step_only(mask: &Mask<BigRational>) -> Option<Smoothness<BigRational>> {
    mask.smoothness(1)
}

/// Forgets the factors 2: contracts the differences instead of the divided differences.
pub fn not_divided(mask: &Mask<BigRational>) -> Option<Smoothness<BigRational>> {
    (0..mask.sum_rules()).rev().find_map(|order| {
        let scheme = (0..=order).try_fold(mask.clone(), |mask, _| mask.difference_scheme())?;
        Some(Smoothness {
            order,
            contraction: scheme.contraction(6)?,
            difference_scheme: scheme,
        })
    })
}
