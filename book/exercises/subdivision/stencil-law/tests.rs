use cagd::check::claim;
use cagd::scalar::{BigRational, Scalar};

type Q = BigRational;
type Matrix = Vec<Vec<Q>>;

fn list(numerators: &[i64], denominator: i64) -> Vec<Q> {
    let entry = |&n: &i64| <Q as Scalar>::from_ratio(n, denominator);
    numerators.iter().map(entry).collect()
}

/// The matrices of Chaikin's scheme, of the cubic scheme, of degree 4 and of the four-point scheme.
fn matrices() -> [Matrix; 4] {
    let rows = |rows: &[&[i64]], denominator: i64| -> Matrix {
        rows.iter().map(|row| list(row, denominator)).collect()
    };
    [
        rows(&[&[3, 1], &[1, 3]], 4),
        rows(&[&[4, 4, 0], &[1, 6, 1], &[0, 4, 4]], 8),
        rows(
            &[
                &[5, 10, 1, 0],
                &[1, 10, 5, 0],
                &[0, 5, 10, 1],
                &[0, 1, 10, 5],
            ],
            16,
        ),
        rows(
            &[
                &[0, 16, 0, 0, 0],
                &[-1, 9, 9, -1, 0],
                &[0, 0, 16, 0, 0],
                &[0, -1, 9, 9, -1],
                &[0, 0, 0, 16, 0],
            ],
            16,
        ),
    ]
}

/// The right weights of the matrices, by their size.
fn right(matrix: &[Vec<Q>]) -> Vec<Q> {
    match matrix.len() {
        2 => list(&[1, 1], 2),
        3 => list(&[1, 4, 1], 6),
        4 => list(&[1, 11, 11, 1], 24),
        _ => list(&[0, 0, 1, 0, 0], 1),
    }
}

fn accepts(stencil: fn(&[Vec<Q>]) -> Vec<Q>) -> bool {
    matrices()
        .iter()
        .all(|matrix| answer::law(stencil, matrix).judge().is_ok())
}

fn probes() -> Vec<String> {
    cagd::probes![
        accepts(right),
        accepts(equal_weights),
        accepts(doubled),
        accepts(derivative),
        accepts(derivative_moved),
        accepts(one_step),
        accepts(middle),
        accepts(first_column),
    ]
}

fn fails(what: &str, stencil: fn(&[Vec<Q>]) -> Vec<Q>) {
    claim("the law on wrong weights").input(what).holds(
        !accepts(stencil),
        "the law is violated for some matrix",
        "it holds for all of them",
    );
}

fn equal_weights(matrix: &[Vec<Q>]) -> Vec<Q> {
    let n = matrix.len() as i64;
    list(&vec![1; matrix.len()], n)
}

fn doubled(matrix: &[Vec<Q>]) -> Vec<Q> {
    right(matrix).iter().map(|l| l + l).collect()
}

/// Differences of the end points: they sum to 0.
fn derivative(matrix: &[Vec<Q>]) -> Vec<Q> {
    let mut weights = list(&vec![0; matrix.len()], 1);
    let last = weights.len() - 1;
    weights[0] = <Q as Scalar>::from_integer(-1);
    weights[last] = <Q as Scalar>::from_integer(1);
    weights
}

/// The right weights, moved by weights of sum 0.
fn derivative_moved(matrix: &[Vec<Q>]) -> Vec<Q> {
    right(matrix)
        .iter()
        .zip(derivative(matrix))
        .map(|(l, d)| l + d)
        .collect()
}

/// The rule of the point in the middle, for one step.
fn one_step(matrix: &[Vec<Q>]) -> Vec<Q> {
    matrix[matrix.len() / 2].clone()
}

/// The point in the middle itself.
fn middle(matrix: &[Vec<Q>]) -> Vec<Q> {
    let mut weights = list(&vec![0; matrix.len()], 1);
    weights[matrix.len() / 2] = <Q as Scalar>::from_integer(1);
    weights
}

/// Weights of sum 1 that A leaves as they are in the first column only, where that is possible.
fn first_column(matrix: &[Vec<Q>]) -> Vec<Q> {
    match matrix.len() {
        2 => list(&[1, 1], 2),
        3 => list(&[1, 4, 5], 10),
        4 => list(&[1, 11, 12, 0], 24),
        _ => list(&[0, 0, 0, 1, 0], 1),
    }
}

/// Why: the weights (1, 4, 1)/6 and their like must be accepted.
#[test]
fn it_holds_for_limit_stencils() {
    claim("the law on the weights of the limit").holds(
        accepts(right),
        "it holds for every matrix",
        "it is violated for one of them",
    );
}

/// Why: multiples do not change under A either.
#[test]
fn it_fails_for_multiples() {
    fails("twice the right weights", doubled);
}

/// Why: they sum to 1, but they are a right eigenvector.
#[test]
fn it_fails_for_equal_weights() {
    fails("the mean of the points", equal_weights);
}

/// Why: each column of A is a condition of its own.
#[test]
fn it_fails_for_a_single_column() {
    fails(
        "weights that only the first column leaves unchanged",
        first_column,
    );
}

/// Why: one step is not the limit.
#[test]
fn it_fails_for_one_step() {
    fails("the rule of one step", one_step);
    fails("the point in the middle", middle);
    fails("the right weights moved by a difference", derivative_moved);
}
