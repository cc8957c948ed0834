//! The algorithm of de Casteljau.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The point b(t) of the Bézier curve with the control points b₀, …, bₙ, at least one.
pub fn point<T: Scalar>(b: &[Point<T, 2>], t: T) -> Point<T, 2> {
    let mut points = b.to_vec();
    //@ solution
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| pair[0].lerp(&pair[1], t.clone()))
            .collect();
    }
    //@ starter
    //| // This is one step; how many are needed?
    //| if points.len() > 1 {
    //|     points = points
    //|         .windows(2)
    //|         .map(|pair| pair[0].lerp(&pair[1], t.clone()))
    //|         .collect();
    //| }
    //@ end
    points.swap_remove(0)
}
