//! Two pillows, each of two quadrilaterals with the same corners, that share opposite corners.

/// The faces, each a list of its vertices.
pub fn counterexample() -> Vec<Vec<u32>> {
    vec![
        vec![0, 1, 2, 3],
        vec![3, 2, 1, 0],
        vec![0, 4, 2, 5],
        vec![5, 2, 4, 0],
    ]
}
