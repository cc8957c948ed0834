//! misconception: a sphere and a torus together have V − E + F = 2 + 0; but they are not connected

/// The faces, each a list of its vertices.
pub fn counterexample() -> Vec<Vec<u32>> {
    let tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(Vec::from);
    let vertex = |i: u32, j: u32| 4 + i % 3 + 3 * (j % 3);
    let torus = (0..9).map(|cell| {
        let (i, j) = (cell % 3, cell / 3);
        vec![
            vertex(i, j),
            vertex(i + 1, j),
            vertex(i + 1, j + 1),
            vertex(i, j + 1),
        ]
    });
    tetrahedron.into_iter().chain(torus).collect()
}
