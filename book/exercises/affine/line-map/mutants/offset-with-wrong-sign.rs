//! misconception: to get b one adds a·t₀ to the first value

use cagd::scalar::Scalar;

/// Slope and offset.
pub fn line_map<T: Scalar>(t: &[T; 2], y: &[T; 2]) -> Option<[T; 2]> {
    let [t0, t1] = t.clone();
    let [y0, y1] = y.clone();
    if t0 == t1 {
        return None;
    }
    let a = (y1 - y0.clone()) / (t1 - t0.clone());
    Some([a.clone(), y0 + a * t0])
}
