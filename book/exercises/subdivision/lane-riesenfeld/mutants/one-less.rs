//! misconception: doubling counts as the first of n rounds, so n − 1 averagings are left; but it is no averaging, and n follow it

use cagd::scalar::Scalar;

/// The vertices after one step.
pub fn refine<T: Scalar>(values: &[T], degree: usize) -> Vec<T> {
    let half = T::from_ratio(1, 2);
    let mut polygon: Vec<T> = values
        .iter()
        .flat_map(|value| [value.clone(), value.clone()])
        .collect();
    for _ in 1..degree {
        polygon = polygon
            .windows(2)
            .map(|leg| (leg[0].clone() + leg[1].clone()) * half.clone())
            .collect();
    }
    polygon
}
