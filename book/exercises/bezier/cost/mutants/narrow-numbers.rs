//! misconception: 2ⁿ⁺¹ − 1 is not that large, so it may be computed with 32 bits

/// The number of linear interpolations.
pub fn interpolations(n: u32) -> u64 {
    u64::from(n * (n + 1) / 2)
}

/// The number of calls.
pub fn calls(n: u32) -> u64 {
    u64::from(2_u32.wrapping_pow(n + 1).wrapping_sub(1))
}
