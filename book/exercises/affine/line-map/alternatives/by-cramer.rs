//! By the two determinants of the equations a·tₖ + b = yₖ.
use cagd::scalar::Scalar;

/// Slope and offset.
pub fn line_map<T: Scalar>(t: &[T; 2], y: &[T; 2]) -> Option<[T; 2]> {
    let [t0, t1] = t.clone();
    let [y0, y1] = y.clone();
    let determinant = t0.clone() - t1.clone();
    if determinant.is_zero() {
        return None;
    }
    let a = (y0.clone() - y1.clone()) / determinant.clone();
    let b = (t0 * y1 - t1 * y0) / determinant;
    Some([a, b])
}
