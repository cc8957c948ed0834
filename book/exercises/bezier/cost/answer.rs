//! The cost of the algorithm of de Casteljau.

/// How many linear interpolations fill the triangle of de Casteljau for degree n.
pub fn interpolations(n: u32) -> u64 {
    //@ solution
    u64::from(n) * u64::from(n + 1) / 2
    //@ starter
    //| // The first column besides the control points.
    //| u64::from(n)
    //@ end
}

/// How many calls the recursive program makes for degree n, the first one included.
pub fn calls(n: u32) -> u64 {
    //@ solution
    2_u64.pow(n + 1) - 1
    //@ starter
    //| // The first call, and no other yet.
    //| let _ = n;
    //| 1
    //@ end
}
