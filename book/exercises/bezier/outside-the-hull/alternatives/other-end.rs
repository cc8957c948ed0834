//! At the other end, with degree 4.

/// The control points, and the parameter t = p/q as (p, q).
pub fn counterexample() -> (Vec<[i64; 2]>, (i64, i64)) {
    (
        vec![[20, 0], [-20, 30], [-20, -30], [5, 0], [0, 0]],
        (21, 20),
    )
}
