//! misconception: it is enough that the polygons differ somewhere, so any values will do

/// The control values.
pub fn counterexample() -> Vec<i64> {
    vec![0, 4, 20, 64]
}
