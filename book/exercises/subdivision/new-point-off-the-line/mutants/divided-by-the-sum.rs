//! misconception: weights of any sum become right when they are divided by their sum; but these are still not symmetric

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new point.
pub fn new_point<T: Scalar>(p: &[Point<T, 2>; 4], w: T) -> Point<T, 2> {
    let half = T::from_ratio(1, 2);
    let mut weights = [-w.clone(), half.clone() + w.clone(), half * w.clone(), -w];
    let sum = weights
        .iter()
        .fold(T::zero(), |sum, weight| sum + weight.clone());
    if !sum.is_zero() {
        for weight in &mut weights {
            *weight /= sum.clone();
        }
    }
    let coordinate = |k: usize| {
        let terms = weights.iter().zip(p);
        terms.fold(T::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point[k].clone()
        })
    };
    Point::new([coordinate(0), coordinate(1)])
}
