//! misconception: every degree averages at least once; but degree 0 doubles the vertices and nothing else

use cagd::scalar::Scalar;

/// The vertices after one step.
pub fn refine<T: Scalar>(values: &[T], degree: usize) -> Vec<T> {
    let half = T::from_ratio(1, 2);
    let mut polygon: Vec<T> = values
        .iter()
        .flat_map(|value| [value.clone(), value.clone()])
        .collect();
    for _ in 0..degree.max(1) {
        polygon = polygon
            .windows(2)
            .map(|leg| (leg[0].clone() + leg[1].clone()) * half.clone())
            .collect();
    }
    polygon
}
