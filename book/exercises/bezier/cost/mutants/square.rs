//! misconception: n columns with n entries each are n² interpolations

/// How many linear interpolations fill the triangle of de Casteljau for degree n.
pub fn interpolations(n: u32) -> u64 {
    u64::from(n) * u64::from(n)
}

/// How many calls the recursive program makes for degree n, the first one included.
pub fn calls(n: u32) -> u64 {
    2_u64.pow(n + 1) - 1
}
