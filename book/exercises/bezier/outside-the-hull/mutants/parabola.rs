//! misconception: beyond its end the curve comes back to its hull, whatever the polygon is

/// The control points, and the parameter t = p/q as (p, q).
pub fn counterexample() -> (Vec<[i64; 2]>, (i64, i64)) {
    (vec![[0, 0], [2, 4], [4, 0]], (3, 2))
}
