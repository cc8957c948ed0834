//! By the two equations M − A = β(B − A) + γ(C − A), solved by elimination.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The image of `m`.
pub fn image<T: Scalar>(
    corners: &[Point<T, 2>; 3],
    images: &[Point<T, 2>; 3],
    m: &Point<T, 2>,
) -> Option<Point<T, 2>> {
    let [a, b, c] = corners.clone();
    let (v, w, x) = (b - a.clone(), c - a.clone(), m.clone() - a);
    // A row with v ≠ 0 is the first one.
    let k = (0..2).find(|&k| !v[k].is_zero())?;
    let other = 1 - k;
    let factor = v[other].clone() / v[k].clone();
    let below = w[other].clone() - factor.clone() * w[k].clone();
    if below.is_zero() {
        return None;
    }
    let gamma = (x[other].clone() - factor * x[k].clone()) / below;
    let beta = (x[k].clone() - gamma.clone() * w[k].clone()) / v[k].clone();
    let [a, b, c] = images.clone();
    Some(a.clone() + (b - a.clone()) * beta + (c - a) * gamma)
}
