use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

type Q = BigRational;

fn mask(numerators: &[i64], denominator: i64) -> Vec<Q> {
    let fraction = |&n: &i64| <Q as Scalar>::from_ratio(n, denominator);
    numerators.iter().map(fraction).collect()
}

fn probes() -> Vec<String> {
    let chaikin = mask(&[1, 3, 3, 1], 4);
    cagd::probes![
        answer::steps(&chaikin, 0),
        answer::steps(&chaikin, 1),
        answer::steps(&chaikin, 2),
        answer::steps(&mask(&[1, 2], 1), 4),
    ]
}

/// The number 1 among zeros, refined: the new number of index i is Σⱼ aᵢ₋₂ⱼ·pⱼ.
fn refined(mask: &[Q], count: usize) -> Vec<Q> {
    let zero = <Q as Scalar>::from_integer(0);
    let mut data = vec![<Q as Scalar>::from_integer(1)];
    for _ in 0..count {
        let length = 2 * (data.len() - 1) + mask.len();
        let rule = |i: usize| {
            let terms = data.iter().enumerate().filter(|(j, _)| 2 * j <= i);
            let weighted = terms.filter_map(|(j, p)| Some(mask.get(i - 2 * j)? * p));
            weighted.fold(zero.clone(), |sum, term| sum + term)
        };
        data = (0..length).map(rule).collect();
    }
    data
}

fn compare(mask: &[Q], count: usize) {
    claim("the mask of the steps")
        .input(format!("a = {mask:?}, steps = {count}"))
        .equal(answer::steps(mask, count), refined(mask, count));
}

/// Why: the empty product is 1.
#[test]
fn no_step() {
    compare(&mask(&[1, 3, 3, 1], 4), 0);
}

/// Why: one step has the mask itself.
#[test]
fn one_step() {
    compare(&mask(&[1, 3, 3, 1], 4), 1);
}

/// Why: (1 + 2z)(1 + 2z²) = 1 + 2z + 2z² + 4z³ can be multiplied by hand.
#[test]
fn two_short_factors() {
    claim("the mask of two steps")
        .input("a = 1 + 2z")
        .equal(answer::steps(&mask(&[1, 2], 1), 2), mask(&[1, 2, 2, 4], 1));
}

proptest! {
    /// Why: three factors tell z⁴ from z⁶, and any coefficients tell a product from a power.
    #[test]
    fn any_mask(numerators in prop::collection::vec(-4_i64..=4, 1..5), count in 0_usize..=4) {
        compare(&mask(&numerators, 4), count);
    }
}
