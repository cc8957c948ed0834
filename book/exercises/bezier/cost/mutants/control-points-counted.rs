//! misconception: the control points are entries of the triangle, so they cost an interpolation as well

/// How many linear interpolations fill the triangle of de Casteljau for degree n.
pub fn interpolations(n: u32) -> u64 {
    u64::from(n + 1) * u64::from(n + 2) / 2
}

/// How many calls the recursive program makes for degree n, the first one included.
pub fn calls(n: u32) -> u64 {
    2_u64.pow(n + 1) - 1
}
