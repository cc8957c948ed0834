//! The control points of a curve over another interval, as values of its blossom.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of t ↦ b((1 − t)c + td) for the curve with the control points b, at least one.
pub fn points_over<T: Scalar>(b: &[Point<T, 2>], c: T, d: T) -> Vec<Point<T, 2>> {
    //@ solution
    let n = b.len() - 1;
    let value = |ends: usize| {
        let mut column = b.to_vec();
        for step in 0..n {
            let x = if step < ends { &d } else { &c };
            column = column
                .windows(2)
                .map(|pair| pair[0].lerp(&pair[1], x.clone()))
                .collect();
        }
        column[0].clone()
    };
    (0..=n).map(value).collect()
    //@ starter
    //| // This is right for c = 0 and d = 1 only.
    //| let _ = (c, d);
    //| b.iter().map(|point| point.lerp(point, T::zero())).collect()
    //@ end
}
