//! misconception: all points beside the edge have negative weights; but c and d have 1/8, and only the wings have −1/16

/// The heights of a, b, c, d and of the four wings.
pub fn counterexample() -> [i64; 8] {
    [0, 0, 16, 16, 16, 16, 16, 16]
}
