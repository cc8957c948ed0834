//! A polygon with a hole, for which Pick's formula fails.

/// A region between two polygons, and its numbers.
pub struct Region {
    /// The vertices of the outer polygon, in order.
    pub outer: Vec<[i64; 2]>,
    /// The vertices of the hole, in order.
    pub hole: Vec<[i64; 2]>,
    /// The number of lattice points between the two, I.
    pub interior: i64,
    /// The number of lattice points on both boundaries, R.
    pub boundary: i64,
    /// Twice the area between the two, 2A.
    pub twice_area: i64,
}

/// A region for which the area is not I + R/2 − 1.
pub fn region() -> Region {
    //@ solution
    Region {
        outer: vec![[0, 0], [3, 0], [3, 3], [0, 3]],
        hole: vec![[1, 1], [2, 1], [2, 2], [1, 2]],
        interior: 0,
        boundary: 12 + 4,
        twice_area: 2 * (9 - 1),
    }
    //@ starter
    //| // The numbers are those of the outer square without a hole, for which the formula holds.
    //| Region {
    //|     outer: vec![[0, 0], [3, 0], [3, 3], [0, 3]],
    //|     hole: vec![],
    //|     interior: 4,
    //|     boundary: 12,
    //|     twice_area: 18,
    //| }
    //@ end
}
