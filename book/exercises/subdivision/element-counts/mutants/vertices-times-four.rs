//! misconception: everything is four times as many after a step, the vertices too; but that is exact on a torus only

/// [V, E, F] of a closed mesh of triangles after `steps` steps of Loop's scheme.
pub fn loop_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    counts.map(|count| 4_u64.pow(steps) * count)
}

/// [V, E, F] of a closed mesh of any faces after `steps` steps of Catmull–Clark subdivision.
pub fn catmull_clark_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    counts.map(|count| 4_u64.pow(steps) * count)
}
