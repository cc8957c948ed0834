//! misconception: an inner start is enough, however far t is from the interval

/// The control points, and the parameter t = p/q as (p, q).
pub fn counterexample() -> (Vec<[i64; 2]>, (i64, i64)) {
    (vec![[0, 0], [6, 0], [-6, 6], [-6, -6]], (-3, 1))
}
