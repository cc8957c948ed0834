//! misconception: in a closed mesh F = E/2; but that holds after the first step of Catmull–Clark subdivision, not before

/// [V, E, F] of a closed mesh of triangles after `steps` steps of Loop's scheme.
pub fn loop_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    (0..steps).fold(counts, |[v, e, f], _| [v + e, 2 * e + 3 * f, 4 * f])
}

/// [V, E, F] of a closed mesh of any faces after `steps` steps of Catmull–Clark subdivision.
pub fn catmull_clark_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    let [v, e, f] = counts;
    let edges = 4_u64.pow(steps) * e;
    [v + f + edges / 2 - e, edges, edges / 2]
}
