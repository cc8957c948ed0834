//! misconception: the opposite points cancel on a grid, so they may be left out everywhere; at other valences they do not cancel

use cagd::scalar::Scalar;

/// The point beyond a vertex, on the edge to `neighbours[0]`; one coordinate of it.
pub fn virtual_point<T: Scalar>(neighbours: &[T], opposite: &[T]) -> T {
    let n = neighbours.len();
    // The sum of `count` points, of which the first is `back` places before that with the number 0.
    let near = |points: &[T], back: usize, count: usize| {
        (0..count).fold(T::zero(), |sum, j| sum + points[(n - back + j) % n].clone())
    };
    let all = |points: &[T]| points.iter().fold(T::zero(), |sum, p| sum + p.clone());
    let share = T::from_ratio(4, n as i64);
    let _ = opposite;
    share * all(neighbours) - near(neighbours, 1, 3)
}
