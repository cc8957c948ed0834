//! misconception: the control points are points of the curve, at equal steps between c and d

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of t ↦ b((1 − t)c + td) for the curve with the control points b, at least one.
pub fn points_over<T: Scalar>(b: &[Point<T, 2>], c: T, d: T) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    let value = |ends: usize| {
        let mut column = b.to_vec();
        for step in 0..n {
            let _ = step;
            let x = c.clone() + (d.clone() - c.clone()) * T::from_ratio(ends as i64, n as i64);
            column = column
                .windows(2)
                .map(|pair| pair[0].lerp(&pair[1], x.clone()))
                .collect();
        }
        column[0].clone()
    };
    (0..=n).map(value).collect()
}
