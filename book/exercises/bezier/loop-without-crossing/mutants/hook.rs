//! misconception: a curve that turns by more than a right angle and comes back must cross itself

/// The four control points.
pub fn control_points() -> [[i64; 2]; 4] {
    [[0, 0], [0, 10], [10, 10], [1, 9]]
}
