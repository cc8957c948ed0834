//! misconception: an affine map multiplies by y₁/t₁, as a linear one does, and b is what is then missing at t₀

use cagd::scalar::Scalar;

/// Slope and offset.
pub fn line_map<T: Scalar>(t: &[T; 2], y: &[T; 2]) -> Option<[T; 2]> {
    let [t0, t1] = t.clone();
    let [y0, y1] = y.clone();
    if t0 == t1 {
        return None;
    }
    let a = if t1.is_zero() {
        y0.clone() / t0.clone()
    } else {
        y1 / t1
    };
    Some([a.clone(), y0 - a * t0])
}
