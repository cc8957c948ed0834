//! misconception: a sphere and a triangle at one of its vertices have 2 + 1 − 1 = 2; but the edges of the triangle have one face only

/// The faces, each a list of its vertices.
pub fn counterexample() -> Vec<Vec<u32>> {
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 4, 5]];
    faces.map(Vec::from).into()
}
