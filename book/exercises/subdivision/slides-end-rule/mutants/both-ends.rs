//! misconception: it is enough that the polygons differ somewhere; but the last value has to be right, and Chaikin moves it if the last two control values differ

/// The control values.
pub fn counterexample() -> Vec<i64> {
    vec![0, 4, 20, 64]
}
