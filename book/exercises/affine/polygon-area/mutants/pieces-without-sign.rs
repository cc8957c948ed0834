//! misconception: each triangle has a positive area, and the areas are added

/// Twice the area.
pub fn twice_area(vertices: &[[i64; 2]]) -> i64 {
    let [x, y] = vertices[0];
    let pairs = vertices[1..].windows(2);
    pairs
        .map(|e| ((e[0][0] - x) * (e[1][1] - y) - (e[0][1] - y) * (e[1][0] - x)).abs())
        .sum()
}
