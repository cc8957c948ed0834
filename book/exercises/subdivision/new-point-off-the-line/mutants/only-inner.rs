//! misconception: only the inner points count; but then the weights sum to 1 + 2w, and the outer ones have −w

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new point.
pub fn new_point<T: Scalar>(p: &[Point<T, 2>; 4], w: T) -> Point<T, 2> {
    let half = T::from_ratio(1, 2);
    let inner = half + w.clone();
    let weights = [T::zero(), inner.clone(), inner, T::zero()];
    let coordinate = |k: usize| {
        let terms = weights.iter().zip(p);
        terms.fold(T::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point[k].clone()
        })
    };
    Point::new([coordinate(0), coordinate(1)])
}
