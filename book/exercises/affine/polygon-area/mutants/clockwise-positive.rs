//! misconception: the determinant of the next vertex and this one, in this order, is the area to the left

/// Twice the area.
pub fn twice_area(vertices: &[[i64; 2]]) -> i64 {
    let next = vertices.iter().cycle().skip(1);
    let edges = vertices.iter().zip(next);
    edges.map(|(p, q)| p[1] * q[0] - p[0] * q[1]).sum()
}
