//! The new point of the four-point scheme with tension.

use cagd::affine::Point;
use cagd::scalar::Scalar;

/// The new point between p₁ and p₂ of four successive points p₀, p₁, p₂, p₃.
pub fn new_point<T: Scalar>(p: &[Point<T, 2>; 4], w: T) -> Point<T, 2> {
    let half = T::from_ratio(1, 2);
    //@ solution
    let inner = half + w.clone();
    let weights = [-w.clone(), inner.clone(), inner, -w];
    //@ starter
    //| // As it is printed.
    //| let weights = [-w.clone(), half.clone() + w.clone(), half * w.clone(), -w];
    //@ end
    let coordinate = |k: usize| {
        let terms = weights.iter().zip(p);
        terms.fold(T::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point[k].clone()
        })
    };
    Point::new([coordinate(0), coordinate(1)])
}
