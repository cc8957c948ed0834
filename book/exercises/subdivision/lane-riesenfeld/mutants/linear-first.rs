//! misconception: linear subdivision comes first and then n averagings, as the last summary of the class notes says; but linear subdivision is doubling and one averaging already

use cagd::scalar::Scalar;

/// The vertices after one step.
pub fn refine<T: Scalar>(values: &[T], degree: usize) -> Vec<T> {
    let half = T::from_ratio(1, 2);
    let mut polygon: Vec<T> = values
        .iter()
        .flat_map(|value| [value.clone(), value.clone()])
        .collect();
    let averagings = if degree == 0 { 0 } else { degree + 1 };
    for _ in 0..averagings {
        polygon = polygon
            .windows(2)
            .map(|leg| (leg[0].clone() + leg[1].clone()) * half.clone())
            .collect();
    }
    polygon
}
