//! misconception: every face is cut into four, also by the first step of Catmull–Clark subdivision; but that is so for quadrilaterals only

/// [V, E, F] of a closed mesh of triangles after `steps` steps of Loop's scheme.
pub fn loop_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    (0..steps).fold(counts, |[v, e, f], _| [v + e, 2 * e + 3 * f, 4 * f])
}

/// [V, E, F] of a closed mesh of any faces after `steps` steps of Catmull–Clark subdivision.
pub fn catmull_clark_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    (0..steps).fold(counts, |[v, e, f], _| [v + e + f, 2 * e + 4 * f, 4 * f])
}
