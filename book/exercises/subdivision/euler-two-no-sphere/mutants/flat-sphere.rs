//! misconception: what is flat is no sphere; but two triangles with the same corners are one, drawn badly: only the faces count

/// The faces, each a list of its vertices.
pub fn counterexample() -> Vec<Vec<u32>> {
    vec![vec![0, 1, 2], vec![2, 1, 0]]
}
