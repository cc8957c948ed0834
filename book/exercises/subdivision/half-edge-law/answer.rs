//! What half-edges must satisfy, as a law.

use cagd::law::{Rounding, Sides};
use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::HalfEdgeTables;

/// A list of half-edges, vertices or edges as numbers.
pub fn numbers(list: &[usize]) -> Vec<BigRational> {
    let number = |&n: &usize| <BigRational as Scalar>::from_integer(n as i64);
    list.iter().map(number).collect()
}

/// Faces as numbers from 1 on; no face is 0.
pub fn face_numbers(faces: &[Option<usize>]) -> Vec<BigRational> {
    let list: Vec<usize> = faces.iter().map(|face| face.map_or(0, |f| f + 1)).collect();
    numbers(&list)
}

/// Claims that the tables are those of half-edges.
pub fn law(tables: &HalfEdgeTables) -> Sides<BigRational> {
    let sides = Sides::new(format!("{tables:?}"));
    let all: Vec<usize> = (0..tables.flip.len()).collect();
    //@ solution
    fn through<E: Copy>(outer: &[E], inner: &[usize]) -> Vec<E> {
        inner.iter().map(|&h| outer[h]).collect()
    }
    let HalfEdgeTables {
        origin,
        flip,
        next,
        prev,
        edge,
        face,
    } = tables;
    let alone = all.iter().filter(|&&h| flip[h] == h).count();
    let exact = Rounding::none;
    sides
        .equal(
            "flip twice",
            numbers(&through(flip, flip)),
            numbers(&all),
            exact(),
        )
        .equal("their own flips", numbers(&[alone]), numbers(&[0]), exact())
        .equal(
            "prev after next",
            numbers(&through(prev, next)),
            numbers(&all),
            exact(),
        )
        .equal(
            "the next face",
            face_numbers(&through(face, next)),
            face_numbers(face),
            exact(),
        )
        .equal(
            "the edge of the flip",
            numbers(&through(edge, flip)),
            numbers(edge),
            exact(),
        )
        .equal(
            "the end",
            numbers(&through(origin, flip)),
            numbers(&through(origin, next)),
            exact(),
        )
    //@ starter
    //| // Only the lengths of two lists so far.
    //| let (found, expected) = ([tables.next.len()], [all.len()]);
    //| sides.equal("one next for each", numbers(&found), numbers(&expected), Rounding::none())
    //@ end
}
