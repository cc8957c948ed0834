use cagd::bezier::bernstein;
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::bernstein_values(1, fraction(1, 3)),
        answer::bernstein_values(3, fraction(1, 3)),
        answer::bernstein_values(4, fraction(2, 1)),
    ]
}

/// The claim that the values are those of the definition, with binomial coefficients.
fn compare(n: usize, t: &BigRational) {
    let defined = (0..=n).map(|l| bernstein(n, l as i64, t.clone()));
    claim(format!("the values of the polynomials of degree {n}"))
        .input(format!("n = {n}, t = {t}"))
        .equal(
            answer::bernstein_values(n, t.clone()),
            defined.collect::<Vec<_>>(),
        );
}

/// Why: the values 2/3, 1/3 and 4/9, 4/9, 1/9 can be computed in the head.
#[test]
fn degree_1_and_2_at_a_third() {
    compare(1, &fraction(1, 3));
    compare(2, &fraction(1, 3));
}

/// Why: at the start all values but the first are 0, and a slip in the order shows at once.
#[test]
fn at_0() {
    for n in 0..=4 {
        compare(n, &fraction(0, 1));
    }
}

/// Why: at the end all values but the last are 0; what is right at 0 may be wrong here.
#[test]
fn at_1() {
    for n in 0..=4 {
        compare(n, &fraction(1, 1));
    }
}

/// Why: exact fractions do not show what rounding does to a high degree.
#[test]
fn they_sum_to_one_in_floating_point() {
    let values = answer::bernstein_values(40, 0.3);
    // By the recursion each value has a relative error of at most γ₁₂₀, and the sum adds 40 roundings.
    let allowed = cagd::law::gamma(160);
    claim("the sum of the values")
        .input("n = 40, t = 0.3")
        .close(values.iter().sum::<f64>(), 1.0, allowed);
}

proptest! {
    /// Why: it tries every degree up to 8, also outside of [0, 1].
    #[test]
    fn every_degree(n in 0..=8_usize, t in -8..=16_i64) {
        compare(n, &fraction(t, 8));
    }
}
