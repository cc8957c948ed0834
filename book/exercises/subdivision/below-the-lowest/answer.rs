//! Heights around an edge for which the Butterfly scheme goes below the lowest.

/// The heights of a, b, c, d and of the four wings, from 0 to 16.
pub fn counterexample() -> [i64; 8] {
    //@ solution
    [0, 0, 0, 0, 16, 16, 16, 16]
    //@ starter
    //| // All heights are equal, and the new one too.
    //| [16; 8]
    //@ end
}
