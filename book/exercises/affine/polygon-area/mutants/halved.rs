//! misconception: twice the area is asked for, but the determinant is four times the area of a triangle

/// Twice the area.
pub fn twice_area(vertices: &[[i64; 2]]) -> i64 {
    let next = vertices.iter().cycle().skip(1);
    let edges = vertices.iter().zip(next);
    edges.map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<i64>() / 2
}
