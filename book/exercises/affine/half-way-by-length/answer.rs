//! A way whose half by length a stretching does not keep.

/// The points P, Q, R of the way, and the factor k ≥ 2 of the stretching (x, y) ↦ (kx, y).
pub fn way() -> ([[i64; 2]; 3], i64) {
    //@ solution
    ([[0, 0], [4, 0], [4, 2]], 2)
    //@ starter
    //| // On a line it is as somebody says.
    //| ([[0, 0], [1, 0], [4, 0]], 2)
    //@ end
}
