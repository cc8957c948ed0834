//! misconception: the more directions the better, so the second segment runs slanted

/// The way and the factor.
pub fn way() -> ([[i64; 2]; 3], i64) {
    ([[0, 0], [4, 0], [7, 4]], 2)
}
