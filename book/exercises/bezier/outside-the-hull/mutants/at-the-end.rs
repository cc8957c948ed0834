//! misconception: an end of the interval lies outside of it

/// The control points, and the parameter t = p/q as (p, q).
pub fn counterexample() -> (Vec<[i64; 2]>, (i64, i64)) {
    (vec![[0, 0], [2, 4], [4, 0]], (1, 1))
}
