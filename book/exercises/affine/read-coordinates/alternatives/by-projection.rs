//! The ratio by scalar products, the test by the determinant.
use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The weights of A and B.
pub fn coordinates<T: Scalar>(a: &Point<T, 2>, b: &Point<T, 2>, g: &Point<T, 2>) -> Option<[T; 2]> {
    let whole = b.clone() - a.clone();
    let part = g.clone() - a.clone();
    let dot = |v: [T; 2], w: [T; 2]| {
        let ([v0, v1], [w0, w1]) = (v, w);
        v0 * w0 + v1 * w1
    };
    let [w, p]: [[T; 2]; 2] = [whole.into(), part.into()];
    let length = dot(w.clone(), w.clone());
    let determinant = dot(w.clone(), [p[1].clone(), -p[0].clone()]);
    if length.is_zero() || !determinant.is_zero() {
        return None;
    }
    let beta = dot(p, w) / length;
    Some([T::one() - beta.clone(), beta])
}
