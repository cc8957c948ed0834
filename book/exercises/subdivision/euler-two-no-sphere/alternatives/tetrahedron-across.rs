//! A tetrahedron with an edge between the poles of an octahedron.

/// The faces, each a list of its vertices.
pub fn counterexample() -> Vec<Vec<u32>> {
    let faces = [
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 5, 2],
        [1, 3, 2],
        [1, 4, 3],
        [1, 5, 4],
        [1, 2, 5],
        [0, 6, 1],
        [0, 1, 7],
        [1, 6, 7],
        [6, 0, 7],
    ];
    faces.map(Vec::from).into()
}
