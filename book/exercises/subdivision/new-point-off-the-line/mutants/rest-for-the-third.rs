//! misconception: the third point gets what is missing to the sum 1; but then the rule is not symmetric

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new point.
pub fn new_point<T: Scalar>(p: &[Point<T, 2>; 4], w: T) -> Point<T, 2> {
    let half = T::from_ratio(1, 2);
    let first = half.clone() + half.clone() * w.clone();
    let second = T::one() + w.clone() + w.clone() - first.clone();
    let weights = [-w.clone(), first, second, -w];
    let coordinate = |k: usize| {
        let terms = weights.iter().zip(p);
        terms.fold(T::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point[k].clone()
        })
    };
    Point::new([coordinate(0), coordinate(1)])
}
