//! misconception: all four weights have a plus sign, as in corner cutting; but the outer ones are −w, so that the new point moves away from the outer points

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new point.
pub fn new_point<T: Scalar>(p: &[Point<T, 2>; 4], w: T) -> Point<T, 2> {
    let half = T::from_ratio(1, 2);
    let inner = half - w.clone();
    let weights = [w.clone(), inner.clone(), inner, w];
    let coordinate = |k: usize| {
        let terms = weights.iter().zip(p);
        terms.fold(T::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point[k].clone()
        })
    };
    Point::new([coordinate(0), coordinate(1)])
}
