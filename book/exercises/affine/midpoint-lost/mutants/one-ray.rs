//! misconception: two points at different heights are enough, and above each other is the simplest choice

/// The points A and B.
pub fn points() -> [[i64; 2]; 2] {
    [[0, 1], [0, 3]]
}
