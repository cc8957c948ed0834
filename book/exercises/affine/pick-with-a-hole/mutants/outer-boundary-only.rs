//! misconception: the boundary of a polygon is its outer line

/// A region between two polygons, and its numbers.
pub struct Region {
    /// The outer polygon.
    pub outer: Vec<[i64; 2]>,
    /// The hole.
    pub hole: Vec<[i64; 2]>,
    /// I.
    pub interior: i64,
    /// R.
    pub boundary: i64,
    /// 2A.
    pub twice_area: i64,
}

/// A region for which the formula fails.
pub fn region() -> Region {
    Region {
        outer: vec![[0, 0], [4, 0], [4, 4], [0, 4]],
        hole: vec![[1, 1], [3, 1], [3, 3], [1, 3]],
        interior: 0,
        boundary: 16,
        twice_area: 24,
    }
}
