//! misconception: duplication is the standard example of a scheme without continuous limits; but it has one sum rule, and its differences stay bounded

/// The coefficients of the mask as pairs (numerator, denominator).
pub fn counterexample() -> Vec<(i64, i64)> {
    vec![(1, 1), (1, 1)]
}
