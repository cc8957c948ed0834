//! The box by interpolation between its corners, the error from hits and misses.

/// Area and standard error.
pub fn estimate(
    low: [f64; 2],
    high: [f64; 2],
    points: &[[f64; 2]],
    contains: impl Fn([f64; 2]) -> bool,
) -> Option<(f64, f64)> {
    let area = (high[0] - low[0]) * (high[1] - low[1]);
    let mut hits = 0.0;
    let mut misses = 0.0;
    for u in points {
        let [x, y] = [0, 1].map(|k| low[k] * (1.0 - u[k]) + high[k] * u[k]);
        if contains([x, y]) {
            hits += 1.0;
        } else {
            misses += 1.0;
        }
    }
    let count: f64 = hits + misses;
    let error = (hits * misses / count).sqrt() / count;
    (count > 0.0).then_some((area * hits / count, area * error))
}
