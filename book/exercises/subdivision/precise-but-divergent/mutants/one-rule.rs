//! misconception: weights of sum 1 in both rules are two sum rules; they are only one, a(−1) = 0

/// The coefficients of the mask as pairs (numerator, denominator).
pub fn counterexample() -> Vec<(i64, i64)> {
    vec![(-2, 1), (0, 1), (0, 1), (5, 1), (3, 1), (-4, 1)]
}
