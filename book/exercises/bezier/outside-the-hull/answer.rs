//! A point of the curve outside of the interval and inside the hull.

/// The control points, and the parameter t = p/q as (p, q).
pub fn counterexample() -> (Vec<[i64; 2]>, (i64, i64)) {
    //@ solution
    (vec![[0, 0], [6, 0], [-6, 6], [-6, -6]], (-1, 10))
    //@ starter
    //| // Outside of the interval, but this curve leaves the hull there.
    //| (vec![[0, 0], [0, 4], [4, 4], [4, 0]], (5, 4))
    //@ end
}
