//! misconception: faces and edges follow from next and flip, so their tables need no claim; but they are stored, and may be wrong

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::HalfEdgeTables;

fn numbers(list: &[usize]) -> Vec<BigRational> {
    let number = |&n: &usize| <BigRational as Scalar>::from_integer(n as i64);
    list.iter().map(number).collect()
}

fn through(outer: &[usize], inner: &[usize]) -> Vec<BigRational> {
    let list: Vec<usize> = inner.iter().map(|&h| outer[h]).collect();
    numbers(&list)
}

/// Claims that the tables are those of half-edges.
pub fn law(tables: &HalfEdgeTables) -> Sides<BigRational> {
    let sides = Sides::new(format!("{tables:?}"));
    let all: Vec<usize> = (0..tables.flip.len()).collect();
    let HalfEdgeTables {
        origin,
        flip,
        next,
        prev,
        edge: _,
        face: _,
    } = tables;
    let exact = Rounding::none;
    let alone = all.iter().filter(|&&h| flip[h] == h).count();
    sides
        .equal("flip twice", through(flip, flip), numbers(&all), exact())
        .equal("their own flips", numbers(&[alone]), numbers(&[0]), exact())
        .equal(
            "prev after next",
            through(prev, next),
            numbers(&all),
            exact(),
        )
        .equal(
            "the end",
            through(origin, flip),
            through(origin, next),
            exact(),
        )
}
