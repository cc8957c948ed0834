use cagd::bezier::binomial;
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn numbers(values: &[i64]) -> Vec<BigRational> {
    values
        .iter()
        .map(|&value| BigRational::from_ratio(value, 1))
        .collect()
}

/// Vertex j is Σᵢ C(n + 1, j + n − 2i)·pᵢ/2ⁿ: another way than by averaging.
fn expected(values: &[BigRational], degree: usize) -> Vec<BigRational> {
    let n = degree as i64;
    let scale = BigRational::from_ratio(1, 1 << degree);
    (0..2 * values.len() as i64 - n)
        .map(|j| {
            (0..)
                .zip(values)
                .fold(BigRational::from_ratio(0, 1), |sum, (i, value)| {
                    let weight: BigRational = binomial(degree + 1, j + n - 2 * i);
                    sum + weight * value * scale.clone()
                })
        })
        .collect()
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::refine(&numbers(&[0, 8, 16, 0]), 3),
        answer::refine(&numbers(&[0, 8]), 1),
        answer::refine(&numbers(&[5]), 0),
    ]
}

fn compare(values: &[BigRational], degree: usize) {
    claim("the vertices after one step")
        .input(format!("p = {values:?}, n = {degree}"))
        .equal(answer::refine(values, degree), expected(values, degree));
}

/// Why: degree 0 doubles and does nothing else.
#[test]
fn degree_zero() {
    compare(&numbers(&[3, -1, 4]), 0);
}

/// Why: midpoints between the vertices, small enough to be followed by hand.
#[test]
fn degree_one() {
    compare(&numbers(&[0, 8, 4]), 1);
}

proptest! {
    /// Why: every degree, also where few vertices or none are left.
    #[test]
    fn every_degree(values in prop::collection::vec(-8..=8_i64, 0..6), degree in 0..=6_usize) {
        compare(&numbers(&values), degree);
    }
}
