use cagd::check::claim;
use cagd::scalar::{BigRational, OrderedScalar, Scalar};
use proptest::prelude::*;

type Q = BigRational;

fn fraction(p: i64, q: i64) -> Q {
    <Q as Scalar>::from_ratio(p, q)
}

fn list(numerators: &[i64], denominator: i64) -> Vec<Q> {
    let entry = |&n: &i64| fraction(n, denominator);
    numerators.iter().map(entry).collect()
}

/// b and b(z)·b(z²) of the four-point scheme for C¹.
fn one_step() -> Vec<Q> {
    list(&[-1, 2, 6, 2, -1], 8)
}

fn two_steps() -> Vec<Q> {
    list(&[1, -2, -8, 2, 7, 16, 32, 16, 7, 2, -8, -2, 1], 64)
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::norm(&one_step(), 1),
        answer::norm(&two_steps(), 2),
        answer::norm(&list(&[3, -1, 2], 1), 0),
        answer::norm(&list(&[3, -1, -2, 5, 1, 1], 1), 1),
    ]
}

fn compare(symbol: &[Q], steps: usize, expected: Q) {
    claim("the norm")
        .input(format!("coefficients {symbol:?}, steps = {steps}"))
        .equal(answer::norm(symbol, steps), expected);
}

/// Why: without a step there is one rule, and the norm is the sum of all absolute values.
#[test]
fn no_step() {
    compare(&list(&[3, -1, 2], 1), 0, fraction(6, 1));
}

/// Why: the norms 1 and 3/4 are those of the page.
#[test]
fn the_four_point_scheme() {
    compare(&one_step(), 1, fraction(1, 1));
    compare(&two_steps(), 2, fraction(3, 4));
}

/// Why: a mask with one coefficient a rule, where sums cannot go wrong.
#[test]
fn single_coefficients() {
    compare(&list(&[1, 1], 1), 1, fraction(1, 1));
    compare(&list(&[1, 2, 2, 4], 1), 2, fraction(4, 1));
}

proptest! {
    /// Why: signs and places of all kinds.
    #[test]
    fn any_symbol(numerators in prop::collection::vec(-6_i64..=6, 1..14), steps in 0_usize..=3) {
        let symbol = list(&numerators, 4);
        let mut sums = vec![fraction(0, 1); 1 << steps];
        for (i, c) in symbol.iter().enumerate() {
            sums[i % (1 << steps)] += OrderedScalar::abs(c);
        }
        let largest = sums.into_iter().fold(fraction(0, 1), OrderedScalar::max);
        compare(&symbol, steps, largest);
    }
}
