//! misconception: a corner at the end is a corner, even if the way does not go on from there

/// The way and the factor.
pub fn way() -> ([[i64; 2]; 3], i64) {
    ([[0, 0], [4, 0], [4, 0]], 2)
}
