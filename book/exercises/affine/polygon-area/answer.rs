//! The area of a polygon with whole coordinates.

/// Twice the area of the simple polygon with these vertices, positive if they go round counterclockwise.
pub fn twice_area(vertices: &[[i64; 2]]) -> i64 {
    //@ solution
    (0..vertices.len())
        .map(|i| {
            let ([px, py], [qx, qy]) = (vertices[i], vertices[(i + 1) % vertices.len()]);
            px * qy - py * qx
        })
        .sum()
    //@ starter
    //| // This is right for a triangle whose first vertex is the origin.
    //| let ([px, py], [qx, qy]) = (vertices[1], vertices[2]);
    //| px * qy - py * qx
    //@ end
}
