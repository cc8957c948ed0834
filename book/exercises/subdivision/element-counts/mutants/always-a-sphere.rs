//! misconception: V − E + F = 2 holds for every closed mesh; but it holds for spheres only

/// [V, E, F] of a closed mesh of triangles after `steps` steps of Loop's scheme.
pub fn loop_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    if steps == 0 {
        return counts;
    }
    let factor = 4_u64.pow(steps);
    let (edges, faces) = (factor * counts[1], factor * counts[2]);
    [2 + edges - faces, edges, faces]
}

/// [V, E, F] of a closed mesh of any faces after `steps` steps of Catmull–Clark subdivision.
pub fn catmull_clark_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    if steps == 0 {
        return counts;
    }
    let edges = 4_u64.pow(steps) * counts[1];
    [2 + edges / 2, edges, edges / 2]
}
