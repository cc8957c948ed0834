//! Another one, in another place and not along the axes.

/// The four control points.
pub fn control_points() -> [[i64; 2]; 4] {
    [[-50, 7], [-43, -52], [24, -38], [-24, -36]]
}
