//! The virtual point of Kobbelt's scheme.

use cagd::scalar::Scalar;

/// The point beyond a vertex, on the edge to `neighbours[0]`; one coordinate of it.
///
/// `neighbours` holds l₀, l₁, … in cyclic order, and `opposite[j]` is the fourth vertex of the face of lⱼ and lⱼ₊₁.
/// Both have the same length, three or more.
pub fn virtual_point<T: Scalar>(neighbours: &[T], opposite: &[T]) -> T {
    let n = neighbours.len();
    // The sum of those with these numbers; n is added, so that −2 is written as 2 before 0.
    let near = |points: &[T], numbers: &[usize]| {
        let sum = |sum: T, &j: &usize| sum + points[(2 * n + j - 2) % n].clone();
        numbers.iter().fold(T::zero(), sum)
    };
    let all = |points: &[T]| points.iter().fold(T::zero(), |sum, p| sum + p.clone());
    let share = T::from_ratio(4, n as i64);
    //@ solution
    let factor = T::from_ratio(1, 9);
    //@ starter
    //| let factor = T::from_ratio(1, 5);
    //@ end
    let of_neighbours = share.clone() * all(neighbours) - near(neighbours, &[1, 2, 3]);
    let of_opposite = near(opposite, &[0, 1, 2, 3]) - share * all(opposite);
    of_neighbours + factor * of_opposite
}
