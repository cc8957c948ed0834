//! A scheme with two sum rules whose differences grow.

/// The coefficients of the mask as pairs (numerator, denominator).
pub fn counterexample() -> Vec<(i64, i64)> {
    //@ solution
    vec![(-1, 1), (0, 1), (3, 2), (1, 1), (3, 2), (0, 1), (-1, 1)]
    //@ starter
    //| // Both sum rules hold, but this is the scheme of midpoints, which converges.
    //| vec![(1, 2), (1, 1), (1, 2)]
    //@ end
}
