//! misconception: large weights are enough, whatever their sum; but the sum rules ask for a(1) = 2

/// The coefficients of the mask as pairs (numerator, denominator).
pub fn counterexample() -> Vec<(i64, i64)> {
    vec![(2, 1), (4, 1), (2, 1)]
}
