//! misconception: flip(flip(h)) = h says everything about flip; but it also holds for a half-edge that is its own flip

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::HalfEdgeTables;

fn numbers(list: &[usize]) -> Vec<BigRational> {
    let number = |&n: &usize| <BigRational as Scalar>::from_integer(n as i64);
    list.iter().map(number).collect()
}

fn face_numbers(faces: &[Option<usize>]) -> Vec<BigRational> {
    let list: Vec<usize> = faces.iter().map(|face| face.map_or(0, |f| f + 1)).collect();
    numbers(&list)
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
        edge,
        face,
    } = tables;
    let next_faces: Vec<Option<usize>> = next.iter().map(|&h| face[h]).collect();
    let exact = Rounding::none;
    sides
        .equal("flip twice", through(flip, flip), numbers(&all), exact())
        .equal(
            "prev after next",
            through(prev, next),
            numbers(&all),
            exact(),
        )
        .equal(
            "the next face",
            face_numbers(&next_faces),
            face_numbers(face),
            exact(),
        )
        .equal(
            "the edge of the flip",
            through(edge, flip),
            numbers(edge),
            exact(),
        )
        .equal(
            "the end",
            through(origin, flip),
            through(origin, next),
            exact(),
        )
}
