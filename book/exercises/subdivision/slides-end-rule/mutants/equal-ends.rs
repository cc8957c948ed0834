//! misconception: what counts is the bend of the polygon in the middle, not its first leg

/// The control values.
pub fn counterexample() -> Vec<i64> {
    vec![0, 0, 8, 0, 0]
}
