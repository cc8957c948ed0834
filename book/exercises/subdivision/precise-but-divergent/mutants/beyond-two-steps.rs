//! misconception: where the norm of two steps is above 1, beyond w = 0.1545, the four-point scheme diverges; but more steps may still have a norm below 1

/// The coefficients of the mask as pairs (numerator, denominator).
pub fn counterexample() -> Vec<(i64, i64)> {
    let (outer, inner) = ((-17, 100), (67, 100));
    vec![outer, (0, 1), inner, (1, 1), inner, (0, 1), outer]
}
