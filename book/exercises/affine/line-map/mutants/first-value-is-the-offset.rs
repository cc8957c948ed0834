//! misconception: the offset b is the first value, as if every map began at t = 0

use cagd::scalar::Scalar;

/// Slope and offset.
pub fn line_map<T: Scalar>(t: &[T; 2], y: &[T; 2]) -> Option<[T; 2]> {
    let [t0, t1] = t.clone();
    let [y0, y1] = y.clone();
    if t0 == t1 {
        return None;
    }
    Some([(y1 - y0.clone()) / (t1 - t0), y0])
}
