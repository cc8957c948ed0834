//! The numbers of vertices, edges and faces of a closed mesh after many steps.

/// [V, E, F] of a closed mesh of triangles after `steps` steps of Loop's scheme.
pub fn loop_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    let [v, e, f] = counts;
    //@ solution
    let factor = 4_u64.pow(steps);
    let (edges, faces) = (factor * e, factor * f);
    [v + (edges - e) - (faces - f), edges, faces]
    //@ starter
    //| // Right for one step.
    //| let _ = steps;
    //| [v + e, 2 * e + 3 * f, 4 * f]
    //@ end
}

/// [V, E, F] of a closed mesh of any faces after `steps` steps of Catmull–Clark subdivision.
pub fn catmull_clark_counts(counts: [u64; 3], steps: u32) -> [u64; 3] {
    let [v, e, f] = counts;
    //@ solution
    if steps == 0 {
        return counts;
    }
    let edges = 4_u64.pow(steps) * e;
    let faces = edges / 2;
    [v + f + (edges - faces) - e, edges, faces]
    //@ starter
    //| // The faces are still missing.
    //| let _ = steps;
    //| [v + e + f, 4 * e, f]
    //@ end
}
