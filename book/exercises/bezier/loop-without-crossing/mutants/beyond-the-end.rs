//! misconception: the polynomial crosses itself, and for which t does not matter

/// The four control points.
pub fn control_points() -> [[i64; 2]; 4] {
    [[0, 0], [0, 10], [10, 10], [1, 3]]
}
