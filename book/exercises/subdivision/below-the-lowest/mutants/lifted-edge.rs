//! misconception: wings that lie low pull the new point down; but their weight is negative, so they push it up

/// The heights of a, b, c, d and of the four wings.
pub fn counterexample() -> [i64; 8] {
    [16, 16, 16, 16, 0, 0, 0, 0]
}
