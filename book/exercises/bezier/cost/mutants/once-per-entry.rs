//! misconception: the recursive program is called once for every entry of the triangle

/// How many linear interpolations fill the triangle of de Casteljau for degree n.
pub fn interpolations(n: u32) -> u64 {
    u64::from(n) * u64::from(n + 1) / 2
}

/// How many calls the recursive program makes for degree n, the first one included.
pub fn calls(n: u32) -> u64 {
    u64::from(n + 1) * u64::from(n + 2) / 2
}
