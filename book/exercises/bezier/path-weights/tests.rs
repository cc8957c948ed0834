use cagd::bezier::{TrianglePaths, bernstein};
use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};
use proptest::prelude::*;

fn fraction(numerator: i64, denominator: i64) -> BigRational {
    BigRational::from_ratio(numerator, denominator)
}

fn probes() -> Vec<String> {
    cagd::probes![
        answer::paths(4, 1),
        answer::paths(2, 4),
        answer::weight(3, 1, fraction(1, 3)),
        answer::weight(2, 3, fraction(1, 3)),
    ]
}

/// Why: the paths of a cubic are few enough to be drawn.
#[test]
fn paths_of_a_cubic() {
    for (k, expected) in [1, 3, 3, 1].into_iter().enumerate() {
        claim("the number of paths")
            .input(format!("n = 3, k = {k}"))
            .equal(answer::paths(3, k), expected);
    }
}

/// Why: a table of the cubic's numbers is no answer; the library lists all paths.
#[test]
fn paths_are_those_that_there_are() {
    for n in 0..=8 {
        for k in 0..=n {
            claim("the number of paths")
                .input(format!("n = {n}, k = {k}"))
                .equal(answer::paths(n, k), TrianglePaths::new(n, k).count() as u64);
        }
    }
}

#[test]
fn beyond_the_last_control_point_there_is_nothing() {
    for (n, k) in [(0, 1), (3, 4), (3, 7)] {
        let input = format!("n = {n}, k = {k}, t = 1/3");
        claim("the number of paths")
            .input(&input)
            .equal(answer::paths(n, k), 0);
        claim("the weight")
            .input(&input)
            .equal(answer::weight(n, k, fraction(1, 3)), fraction(0, 1));
    }
}

proptest! {
    #[test]
    fn weights_are_bernstein_polynomials((n, k) in (0..=7_usize).prop_flat_map(|n| (Just(n), 0..=n)), t in -4..=8_i64) {
        let t = fraction(t, 4);
        let expected = bernstein(n, k as i64, t.clone());
        claim("the weight of b_k in b(t)").equal(answer::weight(n, k, t), expected);
    }
}
