//! misconception: a parameter inside the interval refutes the claim as well, because the point is in the hull

/// The control points, and the parameter t = p/q as (p, q).
pub fn counterexample() -> (Vec<[i64; 2]>, (i64, i64)) {
    (vec![[0, 0], [0, 4], [4, 4], [4, 0]], (1, 2))
}
