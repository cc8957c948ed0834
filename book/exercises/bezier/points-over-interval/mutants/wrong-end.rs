//! misconception: point number i takes c in i places; then the curve runs from d to c

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of t ↦ b((1 − t)c + td) for the curve with the control points b, at least one.
pub fn points_over<T: Scalar>(b: &[Point<T, 2>], c: T, d: T) -> Vec<Point<T, 2>> {
    let n = b.len() - 1;
    let value = |ends: usize| {
        let mut column = b.to_vec();
        for step in 0..n {
            let x = if step < ends { &c } else { &d };
            column = column
                .windows(2)
                .map(|pair| pair[0].lerp(&pair[1], x.clone()))
                .collect();
        }
        column[0].clone()
    };
    (0..=n).map(value).collect()
}
