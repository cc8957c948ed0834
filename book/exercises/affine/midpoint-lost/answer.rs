//! Two points whose midpoint a central projection does not keep.

/// The points A and B, each as \[x, y\] with y > 0.
pub fn points() -> [[i64; 2]; 2] {
    //@ solution
    [[0, 1], [2, 2]]
    //@ starter
    //| // The midpoint (3, 2) of these goes to 3/2, as it should.
    //| [[1, 2], [5, 2]]
    //@ end
}
