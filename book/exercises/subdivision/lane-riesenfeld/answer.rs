//! One step of the algorithm of Lane and Riesenfeld for an open polygon of numbers.

use cagd::scalar::Scalar;

/// The vertices after doubling and `degree` averagings; empty if none are left.
pub fn refine<T: Scalar>(values: &[T], degree: usize) -> Vec<T> {
    //@ solution
    let half = T::from_ratio(1, 2);
    let mut polygon: Vec<T> = values
        .iter()
        .flat_map(|value| [value.clone(), value.clone()])
        .collect();
    for _ in 0..degree {
        polygon = polygon
            .windows(2)
            .map(|leg| (leg[0].clone() + leg[1].clone()) * half.clone())
            .collect();
    }
    polygon
    //@ starter
    //| // Nothing is averaged yet.
    //| let _ = degree;
    //| values
    //|     .iter()
    //|     .flat_map(|value| [value.clone(), value.clone()])
    //|     .collect()
    //@ end
}
