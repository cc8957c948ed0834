//! As sums.

/// How many linear interpolations fill the triangle of de Casteljau for degree n.
pub fn interpolations(n: u32) -> u64 {
    (1..=u64::from(n)).sum()
}

/// How many calls the recursive program makes for degree n, the first one included.
pub fn calls(n: u32) -> u64 {
    (0..=n).map(|level| 1_u64 << level).sum()
}
