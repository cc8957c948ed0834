use cagd::check::claim;
use cagd::scalar::{BigRational, OrderedScalar, Scalar};

type Q = BigRational;

fn whole(n: i64) -> Q {
    <Q as Scalar>::from_integer(n)
}

fn probes() -> Vec<String> {
    cagd::probes![answer::counterexample()]
}

/// The mask, if it is of the form that is asked for.
fn read() -> Vec<Q> {
    let mask = answer::counterexample();
    let small = |n: i64| (-1000..=1000).contains(&n);
    claim("the form of the answer")
        .input(format!("{mask:?}"))
        .holds(
            (1..=9).contains(&mask.len())
                && mask.iter().all(|&(p, q)| small(p) && small(q) && q >= 1),
            "one to nine fractions, of numbers between -1000 and 1000",
            format!("{mask:?}"),
        );
    mask.into_iter()
        .map(|(p, q)| <Q as Scalar>::from_ratio(p, q))
        .collect()
}

/// The quotient by 1 + z and the remainder.
fn divided(mask: &[Q]) -> (Vec<Q>, Q) {
    let mut carried = whole(0);
    let mut quotient = Vec::new();
    for coefficient in mask {
        carried = coefficient - &carried;
        quotient.push(carried.clone());
    }
    let remainder = quotient.pop().unwrap_or_else(|| whole(0));
    (quotient, remainder)
}

/// Why: it tells a learner who forgot that the weights of each rule sum to 1 before the other tests speak of divisions.
#[test]
fn the_sum_is_two() {
    let mask = read();
    let sum: Q = mask.iter().sum();
    claim("the value a(1), the sum of all coefficients")
        .input(format!("{mask:?}"))
        .equal(sum, whole(2));
}

#[test]
fn two_sum_rules_hold() {
    let mask = read();
    let (quotient, first) = divided(&mask);
    let (_, second) = divided(&quotient);
    claim("the remainders of two divisions by 1 + z")
        .input(format!("{mask:?}"))
        .equal([first, second], [whole(0), whole(0)]);
}

#[test]
fn differences_grow() {
    let mask = read();
    let (b, _) = divided(&mask);
    // The rules of the indices 0, …, size − 1, where the mask is put at the indices −size, …
    let size = b.len().saturating_sub(2);
    let entry = |i: usize, j: usize| {
        // b at i − 2j, counted from the first index −size of b.
        let index = (i + size).checked_sub(2 * j);
        index
            .and_then(|k| b.get(k))
            .cloned()
            .unwrap_or_else(|| whole(0))
    };
    let matrix: Vec<Vec<Q>> = (0..size)
        .map(|i| (0..size).map(|j| entry(i, j)).collect())
        .collect();
    let product = |a: &[Vec<Q>]| -> Vec<Vec<Q>> {
        let cell = |i: usize, j: usize| (0..size).map(|k| &a[i][k] * &matrix[k][j]).sum::<Q>();
        (0..size)
            .map(|i| (0..size).map(|j| cell(i, j)).collect())
            .collect()
    };
    let mut power = matrix.clone();
    let mut largest = whole(0);
    for _ in 0..24 {
        let trace: Q = (0..size).map(|i| power[i][i].clone()).sum();
        largest = OrderedScalar::max(largest, OrderedScalar::abs(&trace));
        power = product(&power);
    }
    claim("the traces of the powers of the matrix of differences")
        .input(format!("{mask:?}"))
        .holds(
            largest > whole(size as i64),
            format!("one larger than {size}, the number of rows"),
            format!("the largest is about {}", OrderedScalar::to_f64(&largest)),
        );
}
