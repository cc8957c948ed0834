//! misconception: a large loop is enough; it does not matter that the first and the last leg cross

/// The four control points.
pub fn control_points() -> [[i64; 2]; 4] {
    [[0, 0], [14, 10], [-4, 10], [10, 0]]
}
