//! A cubic curve that crosses itself while its control polygon does not.

/// The four control points.
pub fn control_points() -> [[i64; 2]; 4] {
    //@ solution
    [[0, 0], [0, 10], [10, 10], [1, 6]]
    //@ starter
    //| // The polygon does not meet itself, but there is no loop yet.
    //| [[0, 0], [0, 10], [10, 10], [10, 0]]
    //@ end
}
