//! misconception: the polygon ends at the last vertex, so the edge back to the first is not needed

/// Twice the area.
pub fn twice_area(vertices: &[[i64; 2]]) -> i64 {
    let edges = vertices.windows(2);
    edges.map(|e| e[0][0] * e[1][1] - e[0][1] * e[1][0]).sum()
}
