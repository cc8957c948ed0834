//! The affine map of the line with two given values.

use cagd::scalar::Scalar;

/// The numbers \[a, b\] of the map f(t) = a·t + b with f(t₀) = y₀ and f(t₁) = y₁.
///
/// `None` if t₀ = t₁.
pub fn line_map<T: Scalar>(t: &[T; 2], y: &[T; 2]) -> Option<[T; 2]> {
    //@ solution
    let [t0, t1] = t.clone();
    let [y0, y1] = y.clone();
    if t0 == t1 {
        return None;
    }
    let a = (y1 - y0.clone()) / (t1 - t0.clone());
    let b = y0 - a.clone() * t0;
    Some([a, b])
    //@ starter
    //| // The first value is right.
    //| (t[0] != t[1]).then(|| [T::zero(), y[0].clone()])
    //@ end
}
