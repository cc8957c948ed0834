//! The trapezoids between each edge and the axis y = 0.

/// Twice the area.
pub fn twice_area(vertices: &[[i64; 2]]) -> i64 {
    let mut sum = 0;
    let mut previous = vertices[vertices.len() - 1];
    for &vertex in vertices {
        sum += (previous[0] - vertex[0]) * (previous[1] + vertex[1]);
        previous = vertex;
    }
    sum
}
