//! misconception: a way that turns back is no line, so its half is lost

/// The way and the factor.
pub fn way() -> ([[i64; 2]; 3], i64) {
    ([[0, 0], [6, 0], [2, 0]], 3)
}
