//! misconception: a cusp, where the curve turns back at once, is a crossing

/// The four control points.
pub fn control_points() -> [[i64; 2]; 4] {
    [[0, 0], [0, 16], [16, 16], [8, 15]]
}
