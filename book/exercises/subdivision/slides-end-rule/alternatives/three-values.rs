//! The shortest one.

/// The control values.
pub fn counterexample() -> Vec<i64> {
    vec![-100, 7, 7]
}
