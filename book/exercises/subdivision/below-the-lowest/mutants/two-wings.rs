//! misconception: the stencil has two wings, as a four-point rule has two outer points; but it has four

/// The heights of a, b, c, d and of the four wings.
pub fn counterexample() -> [i64; 8] {
    [0, 0, 0, 0, 16, 16, 0, 0]
}
