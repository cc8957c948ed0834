//! misconception: the farther the wings are lifted, the better; but heights from 0 to 16 are asked for

/// The heights of a, b, c, d and of the four wings.
pub fn counterexample() -> [i64; 8] {
    [0, 0, 0, 0, 32, 32, 32, 32]
}
