//! misconception: half-edges without face are there for convenience, and nobody looks at their prev and next

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
    let alone = all.iter().filter(|&&h| flip[h] == h).count();
    let inner = |entry: &dyn Fn(usize) -> usize| -> Vec<BigRational> {
        let list = all.iter().filter(|&&h| face[h].is_some());
        numbers(&list.map(|&h| entry(h)).collect::<Vec<_>>())
    };
    sides
        .equal("flip twice", through(flip, flip), numbers(&all), exact())
        .equal("their own flips", numbers(&[alone]), numbers(&[0]), exact())
        .equal(
            "prev after next",
            inner(&|h| prev[next[h]]),
            inner(&|h| h),
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
