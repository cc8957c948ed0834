//! misconception: what counts is the bend of the polygon in the middle; but there both polygons always agree, and the first leg decides

/// The control values.
pub fn counterexample() -> Vec<i64> {
    vec![0, 0, 8, 0, 0]
}
