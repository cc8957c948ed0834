//! misconception: if neither coordinate of the two points agrees, nothing can be kept

/// The points A and B.
pub fn points() -> [[i64; 2]; 2] {
    [[1, 2], [3, 6]]
}
