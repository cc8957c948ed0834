//! misconception: with equal steps between the values nothing can go wrong at the far end; but Chaikin cuts the last leg, whatever comes before it

/// The control values.
pub fn counterexample() -> Vec<i64> {
    vec![0, 3, 6, 9]
}
