//! Faces that are no sphere, though V − E + F = 2.

/// The faces, each a list of its vertices.
pub fn counterexample() -> Vec<Vec<u32>> {
    //@ solution
    // Two octahedra with the poles 0 and 1.
    let octahedron = |[a, b, c, d]: [u32; 4]| {
        let north = [[0, a, b], [0, b, c], [0, c, d], [0, d, a]];
        let south = [[1, b, a], [1, c, b], [1, d, c], [1, a, d]];
        [north, south].concat().into_iter().map(Vec::from)
    };
    octahedron([2, 3, 4, 5])
        .chain(octahedron([6, 7, 8, 9]))
        .collect()
    //@ starter
    //| // A tetrahedron, which is a sphere.
    //| vec![vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![2, 0, 3]]
    //@ end
}
