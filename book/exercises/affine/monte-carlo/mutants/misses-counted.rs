//! misconception: the points that are not in the shape are the hits

/// Area and standard error.
pub fn estimate(
    low: [f64; 2],
    high: [f64; 2],
    points: &[[f64; 2]],
    contains: impl Fn([f64; 2]) -> bool,
) -> Option<(f64, f64)> {
    if points.is_empty() {
        return None;
    }
    let size = [high[0] - low[0], high[1] - low[1]];
    let place = |[u, v]: [f64; 2]| [low[0] + u * size[0], low[1] + v * size[1]];
    let hits = points
        .iter()
        .filter(|&&point| !contains(place(point)))
        .count();
    let count = points.len() as f64;
    let share = hits as f64 / count;
    let area = size[0] * size[1];
    Some((area * share, area * (share * (1.0 - share) / count).sqrt()))
}
