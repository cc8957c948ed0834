//! Degree elevation by several degrees, in place.

use cagd::affine::{Affine, Point};
use cagd::scalar::Scalar;

/// The control points of degree m ≥ n of the curve of degree n with the control points b, at least one.
pub fn elevated_to<T: Scalar>(b: &[Point<T, 2>], m: usize) -> Vec<Point<T, 2>> {
    let mut points = b.to_vec();
    //@ solution
    while points.len() <= m {
        // From degree k to degree k + 1, which is the number of points before the step.
        let next_degree = points.len();
        points.push(points[next_degree - 1].clone());
        for i in (1..next_degree).rev() {
            let weight = T::from_ratio(i as i64, next_degree as i64);
            points[i] = points[i].lerp(&points[i - 1], weight);
        }
    }
    //@ starter
    //| let next_degree = points.len();
    //| while points.len() <= m {
    //|     let last = points.len();
    //|     points.push(points[last - 1].clone());
    //|     for i in 1..last {
    //|         let weight = T::from_ratio(i as i64, next_degree as i64);
    //|         points[i] = points[i].lerp(&points[i - 1], weight);
    //|     }
    //| }
    //@ end
    points
}
