//! misconception: points on one line have a hull like any others, so they may serve

/// The control points, and the parameter t = p/q as (p, q).
pub fn counterexample() -> (Vec<[i64; 2]>, (i64, i64)) {
    (vec![[0, 0], [1, 0], [-1, 0], [0, 0]], (11, 10))
}
