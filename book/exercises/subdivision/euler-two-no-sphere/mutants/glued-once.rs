//! misconception: two spheres with one common vertex are no sphere, and that is all; but V − E + F is 2 + 2 − 1 = 3

/// The faces, each a list of its vertices.
pub fn counterexample() -> Vec<Vec<u32>> {
    let faces = [
        [0, 2, 1],
        [0, 1, 3],
        [1, 2, 3],
        [2, 0, 3],
        [0, 5, 4],
        [0, 4, 6],
        [4, 5, 6],
        [5, 0, 6],
    ];
    faces.map(Vec::from).into()
}
