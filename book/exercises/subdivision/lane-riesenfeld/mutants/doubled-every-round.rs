//! misconception: doubling and averaging belong together, so both are done n times; but a step doubles once

use cagd::scalar::Scalar;

/// The vertices after one step.
pub fn refine<T: Scalar>(values: &[T], degree: usize) -> Vec<T> {
    let half = T::from_ratio(1, 2);
    let double = |polygon: &[T]| -> Vec<T> {
        polygon
            .iter()
            .flat_map(|value| [value.clone(), value.clone()])
            .collect()
    };
    let mut polygon = double(values);
    for round in 0..degree {
        if round > 0 {
            polygon = double(&polygon);
        }
        polygon = polygon
            .windows(2)
            .map(|leg| (leg[0].clone() + leg[1].clone()) * half.clone())
            .collect();
    }
    polygon
}
